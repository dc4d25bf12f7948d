#include "voronaut/planners/problem/start_relaxation.h"

#include <algorithm>
#include <cmath>

namespace voronaut {
namespace {

// What the start has, less the rounding of one distance: the start must pass its own test.
constexpr double kRoundingMargin_m = 1e-9;

}  // namespace

StartRelaxation::StartRelaxation(double clearance_m, const Vec2& start, double start_clearance_m)
    : clearance_m_(clearance_m), inside_m_(clearance_m), start_(start) {
  if (start_clearance_m < clearance_m)
    inside_m_ = std::max(0.0, start_clearance_m - kRoundingMargin_m);
}

double StartRelaxation::clearance_at_m(const Vec2& p) const {
  if (!active()) return clearance_m_;
  return (p - start_).squaredNorm() <= clearance_m_ * clearance_m_ ? inside_m_ : clearance_m_;
}

ClearancePieces StartRelaxation::split(const Vec2& a, const Vec2& b) const {
  ClearancePieces pieces;
  const auto add = [&](const Vec2& from, const Vec2& to, double clearance_m) {
    pieces.piece[pieces.count++] = {from, to, clearance_m};
  };
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  if (!active() || length_sq == 0) {
    add(a, b, clearance_at_m(a));
    return pieces;
  }
  // Where the line a + t (b - a) crosses the circle around the start.
  const Vec2 from_start = a - start_;
  const double half_b = from_start.dot(along);
  const double discriminant =
      half_b * half_b - length_sq * (from_start.squaredNorm() - clearance_m_ * clearance_m_);
  if (discriminant <= 0) {
    add(a, b, clearance_m_);
    return pieces;
  }
  const double root = std::sqrt(discriminant);
  const double enter = std::max(0.0, (-half_b - root) / length_sq);
  const double leave = std::min(1.0, (-half_b + root) / length_sq);
  if (enter >= leave) {
    add(a, b, clearance_m_);
    return pieces;
  }
  const Vec2 p_enter = enter == 0 ? a : Vec2(a + enter * along);
  const Vec2 p_leave = leave == 1 ? b : Vec2(a + leave * along);
  if (enter > 0) add(a, p_enter, clearance_m_);
  add(p_enter, p_leave, inside_m_);
  if (leave < 1) add(p_leave, b, clearance_m_);
  return pieces;
}

}  // namespace voronaut
