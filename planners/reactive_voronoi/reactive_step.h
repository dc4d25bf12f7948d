#pragma once

#include <optional>
#include <string_view>

#include "voronaut/planners/problem/belief.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi_config.h"
#include "voronaut/planners/reactive_voronoi/subgoal.h"

// The heart of the papers' planner: from what is known now to where to go now.
namespace voronaut {

// The papers' modes of movement.
enum class ReactiveMode { none, left, right, between };

std::string_view to_string(ReactiveMode mode);

struct ReactiveDecision {
  ReactiveMode mode = ReactiveMode::none;
  Vec2 subgoal_world = Vec2::Zero();  // the goal itself in mode none
};

// What side_hysteresis remembers between steps. Clusters merge, points stay: the obstacle is known
// by one of its points.
struct ReactiveMemory {
  struct Bypass {
    PointId anchor = 0;
    Side side = Side::left;
  };
  std::optional<Bypass> bypass;
};

// "The movement between obstacle, the movement from the left and from the right from obstacles, the
// movement without obstacles": with no relevant obstacle straight to the goal, past a single one on
// the side of the smaller detour (the papers do not say how the side is chosen), between the two
// closest otherwise. No state but `memory`. O(known points).
ReactiveDecision reactive_step(const Belief& belief, const Vec2& goal_world,
                               const ReactiveVoronoiConfig& config, ReactiveMemory& memory);

}  // namespace voronaut
