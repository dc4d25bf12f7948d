#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// The scans of a CARMEN log, gzipped or plain text, ranges at or above max_range_m as misses.
//
// - FLASER n ranges x y theta ...: corrected poses. Beam i points at heading - fov/2 + i * s, with
//   s = fov/n for even n and fov/(n - 1) for odd n. The field of view is what the log says
//   (PARAM laser_front_laser_fov or laser_front_laser_resolution, degrees), else that of the SICK
//   scanner which gives so many beams: 180 deg for 180, 181, 360 and 361, 100 deg for 100, 101,
//   200, 201, 400 and 401.
// - ROBOTLASER1 type start fov resolution max_range accuracy remissions n ranges ...: bearings and
//   the sensor's pose as the line says.
//
// Throws std::runtime_error naming the file and the line: for one that cannot be opened, a gzip
// file that is cut or damaged, more than 1 GiB of text, a broken line, a number of beams whose
// field of view nothing tells, and a log without scans.
std::vector<Scan> read_carmen_log(const std::string& path, double max_range_m);

}  // namespace voronaut
