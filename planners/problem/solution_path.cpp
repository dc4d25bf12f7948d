#include "voronaut/planners/problem/solution_path.h"

#include <stdexcept>

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

const og::PathGeometric* added_path(const ob::ProblemDefinition& problem) {
  const auto* path = dynamic_cast<const og::PathGeometric*>(problem.getSolutionPath().get());
  return path == nullptr || path->getStateCount() == 0 ? nullptr : path;
}

bool reaches_goal(const og::PathGeometric& path, const ob::ProblemDefinition& problem) {
  const auto last = static_cast<unsigned>(path.getStateCount() - 1);
  return problem.getGoal()->isSatisfied(path.getState(last)) && path.check();
}

}  // namespace

const og::PathGeometric& solution_path(const ob::PlannerStatus& status,
                                       const ob::ProblemDefinition& problem) {
  const auto* path = added_path(problem);
  if (path == nullptr)
    throw std::runtime_error("the planner says '" + status.asString() +
                             "' but has added no geometric path");
  return *path;
}

const og::PathGeometric* path_to_goal(const ob::PlannerStatus& status,
                                      const ob::ProblemDefinition& problem) {
  if (status == ob::PlannerStatus::EXACT_SOLUTION) return &solution_path(status, problem);
  if (status != ob::PlannerStatus::APPROXIMATE_SOLUTION) return nullptr;
  const auto* path = added_path(problem);
  return path != nullptr && reaches_goal(*path, problem) ? path : nullptr;
}

}  // namespace voronaut
