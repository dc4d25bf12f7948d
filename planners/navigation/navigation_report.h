#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "voronaut/dynamics/path.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/navigation/replan_policy.h"
#include "voronaut/planners/problem/planning_budget.h"

// What a navigator does and why, for who wants to see inside.
namespace voronaut {

// What the vehicle is about.
enum class ExecutiveState {
  takeoff,         // to its cruise height, before it sets off
  looking_around,  // turning on the spot to see all around
  tracking,        // following its path
  backing_off,     // away from what it is too close to
  retracing,       // back the way it came, out of a pocket
  without_path,    // the planner has none
};

std::string_view to_string(ExecutiveState state);

// As of the latest scan, brought up to date by each call of the navigator.
struct NavigationReport {
  ExecutiveState executive = ExecutiveState::takeoff;
  std::optional<double> departed_s;  // when it had its height and set off
  ReplanReason replan = ReplanReason::none;
  // Of the solve that `replan` asked for.
  SolveEnd solve_end = SolveEnd::planner;
  std::string planner_mode;  // the planner's own word for what it does, empty if it has none
  // Why the planner would not take the latest problem, empty if it did.
  std::string refusal;
  // The proof, found at this scan, that the mission has no path on what is known; empty: none.
  std::string infeasible;
  Setpoint setpoint;
  Vec2 lookahead_world = Vec2::Zero();  // the point that the setpoint heads for
  double speed_scale = 1;               // of the speed asked for, as the governor allowed it
  // The governor's proved track, corners; empty: none. Valid until the next scan.
  std::span<const Vec2> tube_world;
};

// Is told of what happens within one call of Navigator::update(), and changes nothing.
class NavigationObserver {
 public:
  enum class Stage { mapping, planning };

  virtual ~NavigationObserver() = default;
  virtual void stage_begins(Stage) {}
  virtual void stage_ends(Stage) {}
  virtual void path_adopted(const Path&) {}  // followed from now on
};

}  // namespace voronaut
