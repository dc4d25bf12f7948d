#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "voronaut/environments/random.h"
#include "voronaut/environments/sensing/scan.h"
#include "voronaut/environments/shapes/geometry.h"

// Scans for property tests of the map: from circles and walls by brute force, and from a lattice,
// where coordinates are small integers and everything that can touch or be collinear is.
namespace voronaut {

struct ScanWorld {
  std::vector<Circle> circles;
  std::vector<Segment> walls;
};

// Circles of 0.2 to 0.8 m and short walls, in a square of the given side around the origin.
ScanWorld random_scan_world(Random& random, double side_m, int circles, int walls);

// Ranges by brute force, then with probability `dropout` each: replaced by NaN, infinity, zero, a
// negative number or one beyond the range.
Scan cast_scan(const ScanWorld& world, const Pose2& pose, std::shared_ptr<const BeamFan> fan,
               double max_range_m, double noise_m, double dropout, Random& random);

// A fan whose "directions" are integer vectors (not of unit length) and whose ranges are small
// integers, so that every return lies on the integer lattice exactly.
Scan lattice_scan(Random& random, bool full_circle);

Pose2 random_pose(Random& random, double side_m);

}  // namespace voronaut
