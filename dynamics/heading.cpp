#include "voronaut/dynamics/heading.h"

#include <cmath>

namespace voronaut {

double heading_error_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const double sine = from.x() * to.y() - from.y() * to.x();
  const double cosine = from.dot(to);
  double chord = 0;  // 2 sin(e/2), from the form that does not cancel
  if (cosine > 0) {
    chord = sine / std::sqrt(0.5 * (1 + cosine));
  } else {
    chord = std::copysign(std::sqrt(2 * (1 - cosine)), sine);
  }
  return chord * (1 + chord * chord / 24);
}

}  // namespace voronaut
