#include "voronaut/dynamics/attitude.h"

#include <cmath>

namespace voronaut {

Eigen::Quaterniond level_attitude(const Eigen::Vector2d& heading_world) {
  // Half angles: cos(yaw/2) = sqrt((1 + cos)/2), and the sine from whichever form does not cancel.
  const double c = heading_world.x();
  const double s = heading_world.y();
  if (c >= 0) {
    const double w = std::sqrt(0.5 * (1 + c));
    return {w, 0, 0, 0.5 * s / w};
  }
  const double z = std::sqrt(0.5 * (1 - c));
  return {0.5 * s / z, 0, 0, z};
}

Eigen::Quaterniond renormalised(const Eigen::Quaterniond& q) {
  const double scale = 1 / std::sqrt(q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
  return {scale * q.w(), scale * q.x(), scale * q.y(), scale * q.z()};
}

}  // namespace voronaut
