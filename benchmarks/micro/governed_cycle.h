#pragma once

#include <memory>

#include "voronaut/benchmarks/micro/counted_work.h"

namespace voronaut::micro {

// Navigation without planner and mapping, per scan of 91 rays: known-free space brought up to date,
// executive, tracker and governor, over one flight of the quadrotor through a forest of 0.1 trees
// per m2 under VoronoiRoadmap.
std::unique_ptr<CountedWork> make_governed_cycle();

}  // namespace voronaut::micro
