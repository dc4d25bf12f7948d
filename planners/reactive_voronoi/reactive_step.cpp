#include "voronaut/planners/reactive_voronoi/reactive_step.h"

#include <algorithm>
#include <vector>

#include "voronaut/planners/reactive_voronoi/relevant_obstacle.h"

namespace voronaut {
namespace {

using Config = ReactiveVoronoiConfig;

double detour_m(const Vec2& vehicle, const Vec2& subgoal, const Vec2& goal) {
  return (subgoal - vehicle).norm() + (goal - subgoal).norm();
}

std::optional<Side> remembered_side(const RelevantObstacle& obstacle, const Belief& belief,
                                    const ReactiveMemory& memory) {
  if (!memory.bypass || belief.obstacles.cluster_of(memory.bypass->anchor) != obstacle.cluster)
    return std::nullopt;
  return memory.bypass->side;
}

Side chosen_side(const RelevantObstacle& obstacle, const Belief& belief, const Vec2& goal,
                 const Config& config, const ReactiveMemory& memory) {
  if (config.side_hysteresis) {
    if (const auto side = remembered_side(obstacle, belief, memory)) return *side;
  }
  if (config.cut_edges == Config::CutEdges::avoided && obstacle.cut_left != obstacle.cut_right)
    return obstacle.cut_left ? Side::right : Side::left;
  const Vec2& vehicle = belief.pose_world.p_world;
  const double left_m =
      detour_m(vehicle, bypass_subgoal(obstacle, Side::left, vehicle, config), goal);
  const double right_m =
      detour_m(vehicle, bypass_subgoal(obstacle, Side::right, vehicle, config), goal);
  return left_m <= right_m ? Side::left : Side::right;
}

ReactiveDecision bypass(const RelevantObstacle& obstacle, const Belief& belief, const Vec2& goal,
                        const Config& config, ReactiveMemory& memory) {
  const Side side = chosen_side(obstacle, belief, goal, config, memory);
  memory.bypass = {belief.obstacles.first_stored(obstacle.cluster), side};
  return {side == Side::left ? ReactiveMode::left : ReactiveMode::right,
          bypass_subgoal(obstacle, side, belief.pose_world.p_world, config)};
}

bool is_left_of_way(const Vec2& p, const Vec2& vehicle, const Vec2& goal) {
  return cross(goal - vehicle, p - vehicle) >= 0;
}

// The obstacles, closest first, become one per side of the way: what lies on one side is passed
// together.
std::vector<RelevantObstacle> one_per_side(const std::vector<RelevantObstacle>& obstacles,
                                           const Vec2& vehicle, const Vec2& goal) {
  std::vector<RelevantObstacle> sides;
  for (const RelevantObstacle& each : obstacles) {
    const bool left = is_left_of_way(each.closest_world, vehicle, goal);
    const auto same = std::find_if(sides.begin(), sides.end(), [&](const RelevantObstacle& side) {
      return is_left_of_way(side.closest_world, vehicle, goal) == left;
    });
    if (same == sides.end()) {
      sides.push_back(each);
      continue;
    }
    same->points_world.insert(same->points_world.end(), each.points_world.begin(),
                              each.points_world.end());
    same->cut_left |= each.cut_left;
    same->cut_right |= each.cut_right;
  }
  return sides;
}

}  // namespace

std::string_view to_string(ReactiveMode mode) {
  switch (mode) {
    case ReactiveMode::none:
      return "none";
    case ReactiveMode::left:
      return "left";
    case ReactiveMode::right:
      return "right";
    case ReactiveMode::between:
      return "between";
  }
  return "none";
}

ReactiveDecision reactive_step(const Belief& belief, const Vec2& goal_world, const Config& config,
                               ReactiveMemory& memory) {
  std::vector<RelevantObstacle> obstacles = relevant_obstacles(belief, goal_world, config);
  if (config.pairing == Config::Pairing::across_way)
    obstacles = one_per_side(obstacles, belief.pose_world.p_world, goal_world);
  if (obstacles.empty()) {
    memory.bypass.reset();
    return {ReactiveMode::none, goal_world};
  }
  if (obstacles.size() == 1) return bypass(obstacles[0], belief, goal_world, config, memory);
  return {ReactiveMode::between, between_subgoal(obstacles[0], obstacles[1])};
}

}  // namespace voronaut
