#pragma once

#include <cstdint>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut::test {

// Steele, Lea, Flood: splitmix64, doi 10.1145/2714064.2660195.
class PlanarRandom {
 public:
  explicit PlanarRandom(std::uint64_t seed) : state_(seed) {}

  double uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return low + (high - low) * static_cast<double>(z >> 11) * 0x1p-53;
  }

  Vec2 point(double low, double high) {
    const double x = uniform(low, high);
    return {x, uniform(low, high)};
  }

 private:
  std::uint64_t state_;
};

}  // namespace voronaut::test
