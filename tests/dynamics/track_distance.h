#pragma once

#include <algorithm>
#include <vector>

#include <Eigen/Core>

namespace voronaut::testing {

// From a point to a chain of straight segments.
inline double distance_m(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& track) {
  double closest = (p - track.front()).norm();
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    const Eigen::Vector2d along = track[i + 1] - track[i];
    const double length_sq = along.squaredNorm();
    const double t =
        length_sq > 0 ? std::clamp((p - track[i]).dot(along) / length_sq, 0.0, 1.0) : 0;
    closest = std::min(closest, (p - track[i] - t * along).norm());
  }
  return closest;
}

}  // namespace voronaut::testing
