#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// The FLASER lines of a gzipped CARMEN log with corrected poses: beam i of n points at
// heading - 90 deg + i * s, s = 180/n deg for even n, 180/(n - 1) for odd n; ranges at or above
// max_range_m are misses. Throws std::runtime_error naming the file and the line.
std::vector<Scan> read_carmen_log(const std::string& path, double max_range_m);

}  // namespace voronaut
