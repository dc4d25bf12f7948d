#include "voronaut/environments/generators/walls.h"

#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

// Room for the vehicle between a gap and the side of the hall, and around start and goal.
constexpr double kAside = 0.6;

// A closed hall along +x with start and goal half a spacing from its ends, at drawn heights.
GeneratedWorld hall(double length_m, double width_m, double spacing_m, Random& random) {
  GeneratedWorld world;
  world.bounds = {Vec2::Zero(), {length_m, width_m}};
  add_enclosure(world.shapes, world.bounds);
  world.start = {spacing_m / 2, random.uniform(kAside, width_m - kAside)};
  world.goal = {length_m - spacing_m / 2, random.uniform(kAside, width_m - kAside)};
  return world;
}

}  // namespace

WorldDraw draw_world(const WallsConfig& config, Random& random) {
  const double slack_m = config.hall_width_m - config.gap_m - 2 * kAside;
  if (slack_m < 0) return std::nullopt;
  GeneratedWorld world =
      hall((config.walls + 1) * config.spacing_m, config.hall_width_m, config.spacing_m, random);
  for (int i = 1; i <= config.walls; ++i) {
    const double x_m = i * config.spacing_m;
    add_wall_with_gap(world.shapes, {x_m, 0}, {x_m, config.hall_width_m},
                      kAside + random.uniform(0, slack_m), config.gap_m);
  }
  return world;
}

WorldDraw draw_world(const NarrowGapsConfig& config, Random& random) {
  const double slack_m = config.hall_width_m - config.gap_m - 2 * kAside;
  if (slack_m < 0) return std::nullopt;
  const double pitch_m = config.spacing_m + config.thickness_m;
  GeneratedWorld world = hall(config.walls * pitch_m + config.spacing_m, config.hall_width_m,
                              config.spacing_m, random);
  for (int i = 0; i < config.walls; ++i) {
    const double front_m = config.spacing_m + i * pitch_m;
    const double back_m = front_m + config.thickness_m;
    const double low_m = kAside + random.uniform(0, slack_m);
    world.shapes.polygons.push_back(box(Bounds{{front_m, 0}, {back_m, low_m}}));
    world.shapes.polygons.push_back(
        box(Bounds{{front_m, low_m + config.gap_m}, {back_m, config.hall_width_m}}));
  }
  return world;
}

}  // namespace voronaut
