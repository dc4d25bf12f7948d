#include "voronaut/dynamics/state.h"

#include <cmath>

namespace voronaut {

Eigen::Vector2d VehicleState::heading_world() const {
  const Eigen::Quaterniond& q = q_world_body;
  const double x = 1 - 2 * (q.y() * q.y() + q.z() * q.z());
  const double y = 2 * (q.x() * q.y() + q.w() * q.z());
  const double norm = std::sqrt(x * x + y * y);
  if (norm == 0) return Eigen::Vector2d::UnitX();
  return {x / norm, y / norm};
}

}  // namespace voronaut
