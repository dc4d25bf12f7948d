#pragma once

#include <memory>

#include "voronaut/benchmarks/micro/counted_work.h"

namespace voronaut::micro {

// All of these fly governed under VoronoiRoadmap and scan with 91 rays.

// Navigation without planner and mapping, per scan: known-free space brought up to date, executive,
// tracker and governor, over one flight of the quadrotor through 10 x 10 m of forest, 0.1 trees per
// m2.
std::unique_ptr<CountedWork> make_governed_cycle();

// Known-free space alone, per scan, over one flight of a point mass through 20 x 20 m of forest,
// 0.15 trees per m2.
std::unique_ptr<CountedWork> make_known_free();

// Ten trials of a point mass in such forests from their definition to their row, per vehicle step:
// everything but world and references, which trials share. The bounds are wider by rim_m all
// around.
std::unique_ptr<CountedWork> make_governed_trial(double rim_m);

}  // namespace voronaut::micro
