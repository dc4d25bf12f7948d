#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace voronaut::voronoi_test {

void add_circle(std::vector<Vec2>& points, const Vec2& center, double radius_m) {
  const int n = static_cast<int>(std::ceil(2 * std::numbers::pi * radius_m / kSpacing_m));
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    points.push_back(center + radius_m * Vec2(std::cos(angle), std::sin(angle)));
  }
}

void add_wall(std::vector<Vec2>& points, const Vec2& a, const Vec2& b) {
  const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / kSpacing_m)));
  for (int i = 0; i <= n; ++i) points.push_back(a + (b - a) * i / n);
}

PointWorld forest(Random& random, double per_m2, double side_m) {
  PointWorld world;
  world.start = {0, side_m / 2};
  world.goal = {side_m, side_m / 2};
  world.bounds = {Vec2(-3, -3), Vec2(side_m + 3, side_m + 3)};
  const int trees = static_cast<int>(per_m2 * side_m * side_m);
  for (int i = 0; i < trees; ++i) {
    const Vec2 center(random.uniform(0, side_m), random.uniform(0, side_m));
    const double radius_m = random.uniform(0.3, 0.6);
    if ((center - world.start).norm() < radius_m + 1 || (center - world.goal).norm() < radius_m + 1)
      continue;
    add_circle(world.points, center, radius_m);
  }
  return world;
}

PointWorld rooms(Random& random) {
  constexpr double kRoom_m = 5, kDoor_m = 1.3;
  PointWorld world;
  world.bounds = {Vec2(0, 0), Vec2(3 * kRoom_m, 3 * kRoom_m)};
  world.start = {1, 1};
  world.goal = {3 * kRoom_m - 1, 3 * kRoom_m - 1};
  const Vec2 hi = world.bounds.max;
  add_wall(world.points, {0, 0}, {hi.x(), 0});
  add_wall(world.points, {hi.x(), 0}, hi);
  add_wall(world.points, hi, {0, hi.y()});
  add_wall(world.points, {0, hi.y()}, {0, 0});
  for (int wall = 1; wall <= 2; ++wall) {
    for (int room = 0; room < 3; ++room) {
      for (const bool upright : {true, false}) {
        const double along = room * kRoom_m;
        const double door = along + random.uniform(0.5, kRoom_m - kDoor_m - 0.5);
        const auto at = [&](double t) {
          return upright ? Vec2(wall * kRoom_m, t) : Vec2(t, wall * kRoom_m);
        };
        add_wall(world.points, at(along), at(door));
        add_wall(world.points, at(door + kDoor_m), at(along + kRoom_m));
      }
    }
  }
  return world;
}

PointWorld scattered(Random& random, std::size_t n, double side_m) {
  PointWorld world;
  world.bounds = {Vec2(0, 0), Vec2(side_m, side_m)};
  for (std::size_t i = 0; i < n; ++i)
    world.points.emplace_back(random.uniform(0, side_m), random.uniform(0, side_m));
  const auto place = [&] {
    for (;;) {
      const Vec2 p(random.uniform(0, side_m), random.uniform(0, side_m));
      if (std::all_of(world.points.begin(), world.points.end(),
                      [&](const Vec2& q) { return (p - q).norm() > 0.41; }))
        return p;
    }
  };
  world.start = place();
  world.goal = place();
  return world;
}

double clearance_m(const std::vector<Vec2>& path, const std::vector<Vec2>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i)
    for (const Vec2& p : points)
      least = std::min(least, distance(p, Segment{path[i - 1], path[i]}));
  return least;
}

}  // namespace voronaut::voronoi_test
