#pragma once

#include <Eigen/Core>

namespace voronaut {

// Angle from one heading to another (unit vectors), in (-2.4, 2.4), positive to the left, without a
// transcendental: s (1 + s^2/24) with s = 2 sin(e/2), the first two terms of 2 asin(s/2). Short by
// 3e-4 of itself at 0.5 rad, 2.5 % at 90 deg, 26 % at 180 deg; exactly opposite headings turn left.
double heading_error_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace voronaut
