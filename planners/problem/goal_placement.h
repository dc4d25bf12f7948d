#pragma once

#include <optional>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {

// Where to plan to: the goal itself if it keeps clearance_m from all known points, else the first
// of a few places around it, nearest first, else the nearest place of all within tolerance_m. Empty
// proves that there is none (to 1e-9 m). A planner that is given a goal that is not valid waits for
// a better one until its budget is spent.
std::optional<Vec2> place_for_goal(const Vec2& goal_world, double tolerance_m,
                                   const Bounds& bounds_world, const ObstacleSnapshot& known,
                                   double clearance_m);

}  // namespace voronaut
