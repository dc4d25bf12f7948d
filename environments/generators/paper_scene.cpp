#include "voronaut/environments/generators/paper_scene.h"

#include <cstdint>
#include <numbers>
#include <vector>

#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

// Start at the origin, goal on the x axis.
GeneratedWorld straight_way(double distance_m, double reach_m) {
  GeneratedWorld world;
  world.goal = {distance_m, 0};
  world.bounds = {{-reach_m, -reach_m}, {distance_m + reach_m, reach_m}};
  return world;
}

}  // namespace

WorldDraw draw_world(const PaperSceneConfig& config, Random& random) {
  GeneratedWorld world =
      straight_way(config.distance_m, config.spread_m + config.radius_large_m + config.margin_m);
  // Circles of a cluster may lie so much farther out.
  if (config.clusters > 0) world.bounds = grown(world.bounds, config.cluster_radius_m);
  const Bounds about_the_line{{0, -config.spread_m}, {config.distance_m, config.spread_m}};
  CirclePlacer placer(world.shapes.circles, config.gap_min_m);
  placer.keep_clear(world.start, config.end_clearance_m);
  placer.keep_clear(world.goal, config.end_clearance_m);
  std::vector<Bounds> areas;
  for (int i = 0; i < config.clusters; ++i) {
    const Vec2 place = point_in(about_the_line, random);
    const Vec2 half = Vec2::Constant(config.cluster_radius_m);
    areas.push_back({place - half, place + half});
  }
  if (areas.empty()) areas.push_back(about_the_line);
  const int more = config.circles_max - config.circles_min;
  const int circles =
      config.circles_min + static_cast<int>(random.below(static_cast<std::uint64_t>(more) + 1));
  for (int i = 0; i < circles; ++i) {
    const double radius_m = random.below(2) == 0 ? config.radius_small_m : config.radius_large_m;
    const Bounds& area = areas[static_cast<std::size_t>(i) % areas.size()];
    if (!placer.place([&] { return Circle{point_in(area, random), radius_m}; }))
      return std::nullopt;
  }
  return turned(world, unit_vector(config.bearing_rad));
}

WorldDraw draw_world(const GoalSideConfig& config, Random& random) {
  GeneratedWorld world =
      straight_way(config.distance_m, config.spread_m + 2 * config.radius_max_m + 3);
  CirclePlacer placer(world.shapes.circles, config.gap_min_m);
  placer.keep_clear(world.start, 1);
  // Not in the last stretch of the straight way: the goal must be in sight of the open side.
  const double side_rad = random.uniform(-0.75, 0.75) * std::numbers::pi;
  const double radius_m = random.uniform(config.radius_min_m, config.radius_max_m);
  const double gap_m = random.uniform(config.goal_gap_min_m, config.goal_gap_max_m);
  world.shapes.circles.push_back(
      {world.goal + (radius_m + gap_m) * unit_vector(side_rad), radius_m});
  placer.keep_clear(world.goal, 1);
  const Bounds about_the_line{{0, -config.spread_m}, {config.distance_m, config.spread_m}};
  for (int i = 0; i < config.others; ++i) {
    const double other_radius_m = random.uniform(config.radius_min_m, config.radius_max_m);
    if (!placer.place([&] { return Circle{point_in(about_the_line, random), other_radius_m}; }))
      return std::nullopt;
  }
  return turned(world, unit_vector(config.bearing_rad));
}

}  // namespace voronaut
