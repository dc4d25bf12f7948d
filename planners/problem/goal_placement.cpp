#include "voronaut/planners/problem/goal_placement.h"

#include <cmath>
#include <vector>

namespace voronaut {

namespace {

constexpr int kRings = 4;
constexpr int kDirections = 16;
// cos and sin of 2 pi / 16, written out: the same bits everywhere.
constexpr double kStepCos = 0.92387953251128674;
constexpr double kStepSin = 0.38268343236508978;
// Just inside the tolerance, so that arriving there is arriving.
constexpr double kInside = 0.95;

// On the far side of rounding: a place on a circle is clear of its centre.
constexpr double kBeyond_m = 1e-9;

void add_crossings(const Vec2& a, const Vec2& b, double radius_m, std::vector<Vec2>& places) {
  const Vec2 half = (b - a) / 2;
  const double half_m = half.norm();
  if (half_m == 0 || half_m > radius_m) return;
  const Vec2 aside = left_of(half) * (std::sqrt(radius_m * radius_m - half_m * half_m) / half_m);
  // Outwards from both centres alike.
  const Vec2 beyond = left_of(half) * (kBeyond_m / half_m);
  places.push_back(a + half + aside + beyond);
  places.push_back(a + half - aside - beyond);
}

// Where the circle crosses the line `axis` = level_m.
void add_crossings(const Vec2& center, double radius_m, int axis, double level_m,
                   std::vector<Vec2>& places) {
  const double to_line_m = level_m - center[axis];
  if (std::abs(to_line_m) > radius_m) return;
  const double aside_m = std::sqrt(radius_m * radius_m - to_line_m * to_line_m) + kBeyond_m;
  for (const double sign : {-1.0, 1.0}) {
    Vec2 place;
    place[axis] = level_m;
    place[1 - axis] = center[1 - axis] + sign * aside_m;
    places.push_back(place);
  }
}

// The place closest to the goal is where the bounds come closest to it; or on the clearance circle
// of a known point, on the goal's side; or where two such circles cross, or one and a side of the
// bounds. O(n^2) places for n points near the goal.
std::vector<Vec2> extreme_places(const Vec2& goal, double tolerance_m, const Bounds& bounds,
                                 const ObstacleSnapshot& known, double clearance_m) {
  const double reach_m = tolerance_m + clearance_m;
  std::vector<Vec2> near;
  for (const Vec2& p : known.points()) {
    if ((p - goal).squaredNorm() <= reach_m * reach_m) near.push_back(p);
  }
  const double radius_m = clearance_m + kBeyond_m;
  std::vector<Vec2> places{goal.cwiseMax(bounds.min).cwiseMin(bounds.max)};
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Vec2 out = goal == near[i] ? Vec2::UnitX() : Vec2((goal - near[i]).normalized());
    places.push_back(near[i] + out * radius_m);
    for (std::size_t k = 0; k < i; ++k) add_crossings(near[i], near[k], radius_m, places);
    for (const int axis : {0, 1}) {
      add_crossings(near[i], radius_m, axis, bounds.min[axis], places);
      add_crossings(near[i], radius_m, axis, bounds.max[axis], places);
    }
  }
  return places;
}

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
  std::optional<Vec2> nearest;
  double nearest_m = tolerance_m;
  for (const Vec2& p : extreme_places(goal_world, tolerance_m, bounds_world, known, clearance_m)) {
    const double distance_m = (p - goal_world).norm();
    if (distance_m >= nearest_m || !fits(p)) continue;
    nearest = p;
    nearest_m = distance_m;
  }
  return nearest;
}

}  // namespace voronaut
