#include "voronaut/environments/generators/fields.h"

#include <algorithm>
#include <cmath>

#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

// The square [0, side]^2 in bounds margin_m wider, crossed from side to side at half height.
GeneratedWorld square_world(double side_m, double outside_m, double margin_m) {
  GeneratedWorld world;
  const double reach_m = std::max(margin_m, outside_m + 0.5);
  world.bounds = {Vec2::Constant(-reach_m), Vec2::Constant(side_m + reach_m)};
  world.start = {-outside_m, side_m / 2};
  world.goal = {side_m + outside_m, side_m / 2};
  return world;
}

int count_of(double density_per_m2, double side_m) {
  return static_cast<int>(std::lround(density_per_m2 * side_m * side_m));
}

}  // namespace

WorldDraw draw_world(const ForestConfig& config, Random& random) {
  GeneratedWorld world = square_world(config.side_m, config.outside_m, config.margin_m);
  if (config.crossing == Crossing::corners) {
    world.start = Vec2::Constant(-config.outside_m);
    world.goal = Vec2::Constant(config.side_m + config.outside_m);
  }
  const Bounds square{Vec2::Zero(), Vec2::Constant(config.side_m)};
  CirclePlacer placer(world.shapes.circles, config.gap_min_m);
  for (int i = 0; i < count_of(config.density_per_m2, config.side_m); ++i) {
    const double radius_m = random.uniform(config.radius_min_m, config.radius_max_m);
    if (!placer.place([&] { return Circle{point_in(square, random), radius_m}; }))
      return std::nullopt;
  }
  return world;
}

WorldDraw draw_world(const GridConfig& config, Random& random) {
  constexpr double kOutside = 1.5;
  GeneratedWorld world = square_world(config.side_m, kOutside, 3);
  const double spacing_m = random.uniform(config.spacing_min_m, config.spacing_max_m);
  const double radius_m = random.uniform(config.radius_min_m, config.radius_max_m);
  world.start.y() = random.uniform(0, config.side_m);
  world.goal.y() = random.uniform(0, config.side_m);
  const int per_row = static_cast<int>(config.side_m / spacing_m) + 1;
  // Centred, so that the field's edges look the same from both sides.
  const double first_m = (config.side_m - (per_row - 1) * spacing_m) / 2;
  for (int row = 0; row < per_row; ++row)
    for (int column = 0; column < per_row; ++column)
      world.shapes.circles.push_back(
          {{first_m + column * spacing_m, first_m + row * spacing_m}, radius_m});
  return world;
}

WorldDraw draw_world(const ThinPostsConfig& config, Random& random) {
  GeneratedWorld world = square_world(config.side_m, 1.5, 3);
  const Bounds square{Vec2::Zero(), Vec2::Constant(config.side_m)};
  CirclePlacer placer(world.shapes.circles, config.gap_min_m);
  placer.keep_clear(world.start, 1);
  placer.keep_clear(world.goal, 1);
  // A wall is kept apart as the disc around its middle that holds it; the discs come out again.
  for (int i = 0; i < config.edge_on_walls; ++i) {
    if (!placer.place([&] { return Circle{point_in(square, random), config.wall_length_m / 2}; }))
      return std::nullopt;
    const Vec2 middle = world.shapes.circles.back().center;
    const Vec2 half = config.wall_length_m / 2 * (middle - world.start).normalized();
    world.shapes.segments.push_back({middle - half, middle + half});
  }
  for (int i = 0; i < count_of(config.density_per_m2, config.side_m); ++i) {
    const double radius_m = random.uniform(config.diameter_min_m, config.diameter_max_m) / 2;
    if (!placer.place([&] { return Circle{point_in(square, random), radius_m}; }))
      return std::nullopt;
  }
  world.shapes.circles.erase(world.shapes.circles.begin(),
                             world.shapes.circles.begin() + config.edge_on_walls);
  return world;
}

}  // namespace voronaut
