#pragma once

#include <string>
#include <vector>

#include <ompl/base/PlannerStatus.h>
#include <ompl/base/ProblemDefinition.h>

#include "voronaut/planners/problem/path_request.h"

namespace voronaut {

// What a solve has added to its problem, judged by what was asked for, and by nothing that the
// planner could have changed.
struct SolutionPath {
  std::vector<Vec2> p_world;  // of the path added, whatever the planner says of it; none: no path
  bool to_goal = false;  // the planner says so, and it begins at the start and ends at the goal
  std::string flaw;      // why not, where the planner says so
};

// An approximate solution is a path to the goal if it ends there and all of it is clear: OMPL's PRM
// and PRMstar call a complete path so when the budget is spent before their second thread has seen
// it. Without `geometry` none is looked at so. An exact one may still lead through what is known:
// is_clear() tells.
//
// Throws std::runtime_error, which says what the planner did wrong, if it claims an exact solution
// and has added none, or if a position of its path is no place (is_place()). `space` is the
// problem's: a path of CForest belongs to a wrapper around it.
SolutionPath solution_path(const ompl::base::PlannerStatus& status,
                           const ompl::base::ProblemDefinition& problem,
                           const ompl::base::StateSpace& space, const PathRequest& request,
                           const KnownGeometry* geometry);

}  // namespace voronaut
