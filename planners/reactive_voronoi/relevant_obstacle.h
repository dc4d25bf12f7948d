#pragma once

#include <vector>

#include "voronaut/planners/problem/belief.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi_config.h"

namespace voronaut {

// One obstacle of the base as a step of the planner sees it. What stage 4 merged is one obstacle:
// the vehicle cannot pass between its parts.
struct RelevantObstacle {
  ClusterId cluster = 0;
  std::vector<Vec2> points_world;  // at least one; scan: right to left, map: in stored order
  bool cut_right = false;          // the scan shows it up to an edge of the field of view
  bool cut_left = false;
  Vec2 closest_world = Vec2::Zero();  // the point closest to the vehicle
  double distance_m = 0;              // to that point
};

// The obstacles that the mode depends on, closest first. O(known points).
std::vector<RelevantObstacle> relevant_obstacles(const Belief& belief, const Vec2& goal_world,
                                                 const ReactiveVoronoiConfig& config);

// True if the point lies ahead of the vehicle, not beyond the goal, and within half_width_m of the
// line between them.
bool in_goal_corridor(const Vec2& point, const Vec2& vehicle, const Vec2& goal,
                      double half_width_m);

}  // namespace voronaut
