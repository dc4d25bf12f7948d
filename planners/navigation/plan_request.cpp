#include "voronaut/planners/navigation/plan_request.h"

#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/path_conversion.h"

namespace voronaut {
namespace ob = ompl::base;

namespace {

PlanStatus status_of(const ob::PlannerStatus& solved, bool reactive) {
  switch (static_cast<ob::PlannerStatus::StatusType>(solved)) {
    case ob::PlannerStatus::EXACT_SOLUTION:
      return PlanStatus::to_goal;
    case ob::PlannerStatus::APPROXIMATE_SOLUTION:
      return reactive ? PlanStatus::partial : PlanStatus::none;
    case ob::PlannerStatus::INVALID_START:
    case ob::PlannerStatus::INVALID_GOAL:
    case ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE:
      return PlanStatus::refused;
    default:
      return PlanStatus::none;
  }
}

}  // namespace

Plan ask_for_plan(ob::Planner& planner, const PlannerTraits& traits, PlanningProblem& problem,
                  const PlanningBudget& budget) {
  if (!traits.plans_on_every_scan) {
    if (!problem.goal_has_place()) return {PlanStatus::infeasible, {}, {}, {}, SolveEnd::planner};
    if (planner.isSetup()) planner.clear();
  }
  planner.setProblemDefinition(problem.definition());
  const auto [solved, end] = solve_within(planner, problem.meter(budget));
  const auto* insight = dynamic_cast<const PlannerInsight*>(&planner);

  Plan plan;
  plan.end = end;
  plan.status = status_of(solved, traits.plans_on_every_scan);
  if (plan.status == PlanStatus::refused) plan.refusal = solved.asString();
  if (insight != nullptr) {
    plan.mode = insight->mode();
    if (!solved && insight->proved_no_path()) plan.status = PlanStatus::infeasible;
  }
  if (plan.status == PlanStatus::to_goal || plan.status == PlanStatus::partial) {
    plan.path =
        to_path(*problem.definition()->getSolutionPath()->as<ompl::geometric::PathGeometric>(),
                *problem.space_information()->getStateSpace());
    if (plan.path.empty()) plan.status = PlanStatus::none;
  }
  return plan;
}

}  // namespace voronaut
