#include "voronaut/environments/shapes/clearance_along.h"

#include <algorithm>

namespace voronaut {
namespace {

constexpr double kReach_m = 0.3;
constexpr double kRounding_m = 1e-6;

}  // namespace

double ClearanceAlong::at(const Vec2& p) {
  if (!((p - center_).squaredNorm() <= reach_sq_)) return look_around(p);
  double nearest_m = kInfinity;
  for (const std::uint32_t i : circles_)
    nearest_m = std::min(nearest_m, signed_distance(p, shapes_.circles()[i]));
  for (const std::uint32_t i : edges_)
    nearest_m = std::min(nearest_m, distance(p, shapes_.edges()[i]));
  return nearest_m;
}

// Whoever moves by no more than `reach` gets so much nearer to a shape and so much farther from the
// nearest one. Without a contact nobody gets into a polygon, where clearances are negative.
double ClearanceAlong::look_around(const Vec2& p) {
  const double clearance_m = shapes_.clearance_m(p);
  const double reach_m = std::min(kReach_m, 0.9 * clearance_m);
  reach_sq_ = -1;
  if (!(reach_m > 0.5 * kReach_m) || clearance_m == kInfinity) return clearance_m;
  center_ = p;
  reach_sq_ = reach_m * reach_m;
  const double within_m = clearance_m + 2 * reach_m + kRounding_m;
  circles_.clear();
  edges_.clear();
  shapes_.visit(
      {p - Vec2::Constant(within_m), p + Vec2::Constant(within_m)},
      [&](std::uint32_t i) {
        if (signed_distance(p, shapes_.circles()[i]) <= within_m) circles_.push_back(i);
      },
      [&](std::uint32_t i) {
        if (distance(p, shapes_.edges()[i]) <= within_m) edges_.push_back(i);
      });
  return clearance_m;
}

}  // namespace voronaut
