#pragma once

#include <cmath>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Sign of the turn a -> b -> c in exact arithmetic: > 0 left, < 0 right, 0 collinear. With it
// convex hulls and their intersections depend on no rounding and on no order of computation.
double orientation_exact(const Vec2& a, const Vec2& b, const Vec2& c);

// The same, decided in floating point where the error bound allows it (nearly always). The bound is
// ccwerrboundA of J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", 1997, doi:10.1007/PL00009321.
inline double orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  constexpr double kErrorBound = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double turn = left - right;
  if (std::abs(turn) > kErrorBound * (std::abs(left) + std::abs(right))) return turn;
  return orientation_exact(a, b, c);
}

}  // namespace voronaut
