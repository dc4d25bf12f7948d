#pragma once

#include <string>

#include <ompl/base/Planner.h>

#include "voronaut/dynamics/path.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/problem/problem.h"

// Asking a planner for a path, the same way for every planner.
namespace voronaut {

enum class PlanStatus {
  to_goal,     // the path ends at the goal, or within its tolerance if there is no clear way on
  partial,     // a reactive planner's next leg: ends short of the goal on purpose
  none,        // no path within the budget
  infeasible,  // proved: no path exists on what is known
  refused,     // invalid start or goal, unknown goal type, says the planner: no proof of anything
};

struct Plan {
  PlanStatus status = PlanStatus::none;
  Path path;            // empty unless to_goal or partial
  std::string mode;     // the planner's own word for what it does, empty if it has none
  std::string refusal;  // OMPL's word for why, where refused
  SolveEnd end = SolveEnd::planner;
};

// Solves `problem` (which already looks at the current belief) within `budget`. Planners that plan
// anew are cleared before, reactive ones keep their memory. An approximate solution counts for
// reactive planners only: a global planner that did not reach the goal has no path. Throws
// std::runtime_error if the planner claims a path that it has not added.
Plan ask_for_plan(ompl::base::Planner& planner, const PlannerTraits& traits,
                  PlanningProblem& problem, const PlanningBudget& budget);

}  // namespace voronaut
