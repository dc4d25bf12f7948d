#include "voronaut/planners/problem/goal_placement.h"

namespace voronaut {

namespace {

constexpr int kRings = 4;
constexpr int kDirections = 16;
// cos and sin of 2 pi / 16, written out: the same bits everywhere.
constexpr double kStepCos = 0.92387953251128674;
constexpr double kStepSin = 0.38268343236508978;
// Just inside the tolerance, so that arriving there is arriving.
constexpr double kInside = 0.95;

}  // namespace

std::optional<Vec2> place_for_goal(const Vec2& goal_world, double tolerance_m,
                                   const Bounds& bounds_world, const ObstacleSnapshot& known,
                                   double clearance_m) {
  const auto fits = [&](const Vec2& p) {
    return bounds_world.contains(p) && known.disc_is_clear(p, clearance_m);
  };
  if (fits(goal_world)) return goal_world;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double radius_m = kInside * tolerance_m * ring / kRings;
    Vec2 direction = Vec2::UnitX();
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 p = goal_world + radius_m * direction;
      if (fits(p)) return p;
      direction = Vec2(kStepCos * direction.x() - kStepSin * direction.y(),
                       kStepSin * direction.x() + kStepCos * direction.y());
    }
  }
  return std::nullopt;
}

}  // namespace voronaut
