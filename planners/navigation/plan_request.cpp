#include "voronaut/planners/navigation/plan_request.h"

#include <stdexcept>
#include <utility>

#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/solution_path.h"

namespace voronaut {
namespace ob = ompl::base;

namespace {

// What was solved, where the answer is no path.
PlanStatus status_without_path(const ob::PlannerStatus& solved) {
  switch (static_cast<ob::PlannerStatus::StatusType>(solved)) {
    case ob::PlannerStatus::INVALID_START:
    case ob::PlannerStatus::INVALID_GOAL:
    case ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE:
      return PlanStatus::refused;
    default:
      return PlanStatus::none;
  }
}

// A path may end anywhere within the goal's tolerance, and who stops at its edge has not arrived.
Path led_on_to_goal(Path path, const PlanningProblem& problem) {
  const Vec2& place = problem.request().place_world;
  if (path.back() != place && problem.geometry().motion_is_clear(path.back(), place))
    path.append({.start = path.back(), .end = place});
  return path;
}

void forget_last_question(ob::Planner& planner) {
  // Whether it is set up tells nothing: FMT and BFMT of OMPL 1.5.2 never say so.
  const bool asked_before = planner.getProblemDefinition() != nullptr;
  if (asked_before) planner.clear();
}

// Everything of the plan but its path.
Plan answer_without_path(const ob::PlannerStatus& solved, SolveEnd end, const ob::Planner& planner,
                         const std::string& flaw) {
  Plan plan;
  plan.end = end;
  plan.status = status_without_path(solved);
  if (plan.status == PlanStatus::refused) plan.refusal = solved.asString();
  if (const auto* insight = dynamic_cast<const PlannerInsight*>(&planner)) {
    plan.mode = insight->mode();
    if (!solved && insight->proved_no_path()) plan.status = PlanStatus::infeasible;
  }
  if (!flaw.empty()) plan.refusal = solved.asString() + ", but " + flaw;
  return plan;
}

}  // namespace

Plan ask_for_plan(ob::Planner& planner, const PlannerTraits& traits, PlanningProblem& problem,
                  const PlanningBudget& budget) {
  if (!traits.plans_on_every_scan) {
    if (!problem.goal_has_place()) return {PlanStatus::infeasible, {}, {}, {}, SolveEnd::planner};
    forget_last_question(planner);
  }
  planner.setProblemDefinition(problem.definition());
  const auto [solved, end] = solve_within(planner, problem.meter(budget));

  const bool next_leg =
      traits.plans_on_every_scan && solved == ob::PlannerStatus::APPROXIMATE_SOLUTION;
  const SolutionPath found =
      solution_path(solved, *problem.definition(), *problem.space_information()->getStateSpace(),
                    problem.request(), next_leg ? nullptr : &problem.geometry());
  if (next_leg && found.p_world.empty())
    throw std::runtime_error("the planner says that it has a next leg but has added no path");

  Plan plan = answer_without_path(solved, end, planner, found.flaw);
  if (next_leg || found.to_goal) {
    plan.path = Path::through(found.p_world);
    if (!plan.path.empty()) plan.status = next_leg ? PlanStatus::partial : PlanStatus::to_goal;
  }
  if (plan.status == PlanStatus::to_goal && !traits.plans_on_every_scan)
    plan.path = led_on_to_goal(std::move(plan.path), problem);
  return plan;
}

}  // namespace voronaut
