#include "voronaut/environments/generators/traps.h"

#include <cstdint>
#include <numbers>
#include <vector>

#include "voronaut/environments/generators/placement.h"

namespace voronaut {
namespace {

constexpr double kApproach = 3;  // m of free way before and behind a trap
constexpr double kMargin = 4;    // m of free space around it

}  // namespace

WorldDraw draw_world(const UTrapConfig& config, Random& random) {
  const double half_m = random.uniform(config.width_min_m, config.width_max_m) / 2;
  const double depth_m = random.uniform(config.depth_min_m, config.depth_max_m);
  const double shift_m = random.uniform(-config.shift_max_m, config.shift_max_m);
  GeneratedWorld world;
  const double back_m = kApproach + depth_m;
  add_walls(world.shapes, {{kApproach, shift_m + half_m},
                           {back_m, shift_m + half_m},
                           {back_m, shift_m - half_m},
                           {kApproach, shift_m - half_m}});
  world.goal = {back_m + kApproach, 0};
  const double reach_m = half_m + config.shift_max_m + kMargin;
  world.bounds = {{-kMargin, -reach_m}, {world.goal.x() + kMargin, reach_m}};
  return world;
}

WorldDraw draw_world(const BugTrapConfig& config, Random& random) {
  const double half_m = random.uniform(config.side_min_m, config.side_max_m) / 2;
  const double door_half_m = random.uniform(config.door_min_m, config.door_max_m) / 2;
  GeneratedWorld world;
  // Between the lips there is as much room as between the caps of the door.
  const double edge_m = door_half_m + kWallCapRadius;
  add_walls(world.shapes, {{-half_m + config.lip_m, edge_m},
                           {-half_m, edge_m},
                           {-half_m, half_m},
                           {half_m, half_m},
                           {half_m, -half_m},
                           {-half_m, -half_m},
                           {-half_m, -edge_m},
                           {-half_m + config.lip_m, -edge_m}});
  const Bounds inside{{-half_m + config.lip_m + 1, -half_m + 1}, Vec2::Constant(half_m - 1)};
  if (inside.min.x() > inside.max.x()) return std::nullopt;
  world.start = point_in(inside, random);
  world.goal = {half_m + kApproach, random.uniform(-half_m, half_m)};
  world.bounds = {Vec2::Constant(-half_m - kMargin), {world.goal.x() + kMargin, half_m + kMargin}};
  return world;
}

WorldDraw draw_world(const SpiralConfig& config, Random& random) {
  const double corridor_m = random.uniform(config.corridor_min_m, config.corridor_max_m);
  // Wall i is (i / 2 + 1) corridors long and each turns left: neighbouring turns are one apart.
  std::vector<Vec2> corners = {Vec2::Zero()};
  Vec2 along = Vec2::UnitX();
  for (int arm = 0; arm < config.arms; ++arm) {
    const int corridors = arm / 2 + 1;
    corners.push_back(corners.back() + corridors * corridor_m * along);
    along = left_of(along);
  }
  GeneratedWorld world;
  add_walls(world.shapes, corners);
  world.start = {0, corridor_m / 2};
  Bounds around{corners[0], corners[0]};
  for (const Vec2& corner : corners)
    around = {around.min.cwiseMin(corner), around.max.cwiseMax(corner)};
  const Vec2 middle = (around.min + around.max) / 2;
  const double reach_m = (around.max - around.min).maxCoeff() / 2 + kApproach;
  const Vec2 sides[] = {Vec2::UnitX(), Vec2::UnitY(), -Vec2::UnitX(), -Vec2::UnitY()};
  world.goal = middle + reach_m * sides[random.below(4)];
  const Vec2 reach = Vec2::Constant(reach_m + kMargin);
  world.bounds = {middle - reach, middle + reach};
  if (random.below(2) == 1) {  // mirrored in the x axis
    for (Circle& cap : world.shapes.circles) cap.center.y() = -cap.center.y();
    for (Segment& wall : world.shapes.segments) {
      wall.a.y() = -wall.a.y();
      wall.b.y() = -wall.b.y();
    }
    world.start.y() = -world.start.y();
    world.goal.y() = -world.goal.y();
    const double below_m = -world.bounds.max.y();
    world.bounds.max.y() = -world.bounds.min.y();
    world.bounds.min.y() = below_m;
  }
  return turned(world, sides[random.below(4)]);
}

WorldDraw draw_world(const EnclosedGoalConfig& config, Random& random) {
  const int more = config.corners_max - config.corners_min;
  const int corners =
      config.corners_min + static_cast<int>(random.below(static_cast<std::uint64_t>(more) + 1));
  const double radius_m = random.uniform(config.ring_radius_min_m, config.ring_radius_max_m);
  const double first_rad = random.uniform(0, 2 * std::numbers::pi);
  GeneratedWorld world;
  world.goal = {config.distance_m, 0};
  std::vector<Vec2> ring;
  ring.reserve(static_cast<std::size_t>(corners) + 1);
  for (int i = 0; i < corners; ++i)
    ring.push_back(world.goal +
                   radius_m * unit_vector(first_rad + 2 * std::numbers::pi * i / corners));
  ring.push_back(ring.front());
  add_walls(world.shapes, ring);
  world.bounds = {Vec2::Constant(-radius_m - kMargin),
                  {config.distance_m + radius_m + kMargin, radius_m + kMargin}};
  return world;
}

}  // namespace voronaut
