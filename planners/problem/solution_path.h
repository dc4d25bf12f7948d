#pragma once

#include <ompl/base/PlannerStatus.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/geometric/PathGeometric.h>

namespace voronaut {

// The path that a solve with this status has added to its problem. Throws std::runtime_error, which
// says what the planner did wrong, if there is none.
const ompl::geometric::PathGeometric& solution_path(const ompl::base::PlannerStatus& status,
                                                    const ompl::base::ProblemDefinition& problem);

// The path to the goal, null if the planner claims none; throws as above. An approximate one is if
// it ends there and all of it is valid: OMPL's PRM and PRMstar call a complete path so when the
// budget is spent before their second thread has seen it.
const ompl::geometric::PathGeometric* path_to_goal(const ompl::base::PlannerStatus& status,
                                                   const ompl::base::ProblemDefinition& problem);

}  // namespace voronaut
