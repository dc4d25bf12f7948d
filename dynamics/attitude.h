#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace voronaut {

// Level attitude whose x axis points along `heading_world` (unit vector).
Eigen::Quaterniond level_attitude(const Eigen::Vector2d& heading_world);

// q / |q| for a quaternion that one integration step has taken off the unit sphere.
Eigen::Quaterniond renormalised(const Eigen::Quaterniond& q);

}  // namespace voronaut
