#pragma once

#include <cstdint>

#include <ompl/util/RandomNumbers.h>

namespace voronaut {

// Seeds OMPL for a trial. Its seed is the process's, must be set before anything draws from it, has
// 32 bits, and 0 would become 1.
inline void seed_ompl(std::uint64_t planner_seed) {
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(planner_seed % 0x7fffffffU) + 1);
}

}  // namespace voronaut
