#pragma once

#include <Eigen/Core>

#include "voronaut/dynamics/path.h"

namespace voronaut {

// A curve as coefficients of a quadratic and a linear form, which is how the cart planner paper
// (Soloviev et al.) hands paths to its regulator: psi(P) = P'N P + L P + c vanishes on it. Scaled
// so that |grad psi| = 1 there, psi is the distance from the curve to first order: positive to the
// left of a line and outside of a circle.
struct PathForm {
  Eigen::Matrix2d N = Eigen::Matrix2d::Zero();  // symmetric [1/m]
  Eigen::Vector2d L = Eigen::Vector2d::Zero();
  double c = 0;      // [m]
  double sense = 1;  // of travel: -1 if the gradient points to its right

  // Line: N = 0, L = n', c = -n.P1 with its left normal n. Arc about C of radius R: N = I/(2R),
  // L = -C'/R, c = (C.C - R^2)/(2R). The segment has a length.
  static PathForm of(const PathSegment& segment);

  double psi_m(const Eigen::Vector2d& p) const { return p.dot(N * p) + L.dot(p) + c; }
  // Zero at the centre of a circle and nowhere else.
  Eigen::Vector2d gradient(const Eigen::Vector2d& p) const { return 2 * N * p + L; }
  // Direction of travel (unit vector) where the gradient is `gradient`, which is not zero.
  Eigen::Vector2d tangent(const Eigen::Vector2d& gradient) const {
    return Eigen::Vector2d(gradient.y(), -gradient.x()) * (sense / gradient.norm());
  }
};

}  // namespace voronaut
