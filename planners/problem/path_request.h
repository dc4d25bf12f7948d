#pragma once

#include <span>
#include <string>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

// What a planner was asked for, kept where no planner can reach it: OMPL's problem definition is in
// the planner's hands, with start, goal and threshold, and a path is not judged by that.
struct PathRequest {
  Vec2 start_world = Vec2::Zero();
  Vec2 goal_world = Vec2::Zero();
  Vec2 place_world = Vec2::Zero();  // where to plan to (goal_placement.h), most often the goal
  double goal_tolerance_m = 0.2;    // of either
  Bounds bounds_world;              // of the vehicle's centre
};

// Farther from the origin than this along an axis, or no number: no place [m].
inline constexpr double kFarthestPlace_m = 1e9;
bool is_place(const Vec2& p_world);

// Why a path does not lead from the start to the goal, empty if it does: it has no positions, one
// that is no place, another start or another end. Obstacles are not asked. O(positions).
std::string flaw_of(std::span<const Vec2> path_world, const PathRequest& request);

// Whether all of the path lies within the bounds and clear of what `geometry` knows; false for
// positions that are no places and for no positions. As many checks as positions.
bool is_clear(std::span<const Vec2> path_world, const PathRequest& request,
              const KnownGeometry& geometry);

}  // namespace voronaut
