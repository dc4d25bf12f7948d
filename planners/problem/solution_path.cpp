#include "voronaut/planners/problem/solution_path.h"

#include <stdexcept>

#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/problem/path_conversion.h"

namespace voronaut {

namespace ob = ompl::base;

SolutionPath solution_path(const ob::PlannerStatus& status, const ob::ProblemDefinition& problem,
                           const ob::StateSpace& space, const PathRequest& request,
                           const KnownGeometry* geometry) {
  SolutionPath solution;
  const auto* path =
      dynamic_cast<const ompl::geometric::PathGeometric*>(problem.getSolutionPath().get());
  if (path != nullptr) solution.p_world = positions_of(*path, space);
  const auto breach = [&status](const char* what) {
    return std::runtime_error("the planner says '" + status.asString() + "' but " + what);
  };
  const bool exact = status == ob::PlannerStatus::EXACT_SOLUTION;
  if (exact && solution.p_world.empty()) throw breach("has added no geometric path");
  for (const Vec2& p : solution.p_world) {
    if (!is_place(p)) throw breach("its path has a position that is no place");
  }
  if (!exact && status != ob::PlannerStatus::APPROXIMATE_SOLUTION) return solution;
  const std::string flaw = flaw_of(solution.p_world, request);
  const auto clear = [&] {
    return geometry != nullptr && is_clear(solution.p_world, request, *geometry);
  };
  solution.to_goal = flaw.empty() && (exact || clear());
  if (exact) solution.flaw = flaw;
  return solution;
}

}  // namespace voronaut
