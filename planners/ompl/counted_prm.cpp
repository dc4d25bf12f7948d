#include "voronaut/planners/ompl/counted_prm.h"

#include <ompl/base/OptimizationObjective.h>

namespace voronaut {

namespace ob = ompl::base;

namespace {

// Evaluations of the termination condition in one turn: two to one, as OMPL divides its time.
constexpr int kGrowing = 100;
constexpr int kExpanding = 50;

ob::PlannerTerminationCondition turn(const ob::PlannerTerminationCondition& ptc, int evaluations) {
  return ob::PlannerTerminationCondition(
      [&ptc, left = evaluations]() mutable { return ptc() || left-- <= 0; });
}

}  // namespace

CountedPrm::CountedPrm(const ob::SpaceInformationPtr& si) : PRM(si) {
  setName("PRMcounted");
  specs_.multithreaded = false;
}

bool CountedPrm::take_in_starts() {
  while (const ob::State* start = pis_.nextStart())
    startM_.push_back(addMilestone(si_->cloneState(start)));
  return !startM_.empty();
}

bool CountedPrm::take_in_goals(const ob::GoalSampleableRegion& goal,
                               const ob::PlannerTerminationCondition& ptc) {
  if (goalM_.size() < goal.maxSampleCount()) {
    const ob::State* state = goalM_.empty() ? pis_.nextGoal(ptc) : pis_.nextGoal();
    if (state != nullptr) goalM_.push_back(addMilestone(si_->cloneState(state)));
  }
  return !goalM_.empty();
}

ob::PlannerStatus CountedPrm::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal == nullptr) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  if (!take_in_starts()) return ob::PlannerStatus::INVALID_START;
  if (!goal->couldSample() || !take_in_goals(*goal, ptc)) return ob::PlannerStatus::INVALID_GOAL;

  bestCost_ = opt_->infiniteCost();
  addedNewSolution_ = false;
  ob::PathPtr best;
  bool growing = true;
  do {
    take_in_goals(*goal, ptc);
    addedNewSolution_ = maybeConstructSolution(startM_, goalM_, best);
    if (addedNewSolution_ || ptc()) break;
    if (growing)
      growRoadmap(turn(ptc, kGrowing));
    else
      expandRoadmap(turn(ptc, kExpanding));
    growing = !growing;
  } while (true);
  return publish(best);
}

ob::PlannerStatus CountedPrm::publish(const ob::PathPtr& exact) {
  ob::PathPtr path = exact;
  double short_of_goal = -1;  // unknown to OMPL: exact
  if (!path) {
    const ob::Cost to_go = constructApproximateSolution(startM_, goalM_, path);
    if (!path || !opt_->isFinite(to_go)) return ob::PlannerStatus::TIMEOUT;
    short_of_goal = to_go.value();
  }
  ob::PlannerSolution solution(path);
  solution.setPlannerName(getName());
  if (exact)
    solution.setOptimized(opt_, bestCost_, addedNewSolution_);
  else
    solution.setApproximate(short_of_goal);
  pdef_->addSolutionPath(solution);
  return {true, !exact};
}

}  // namespace voronaut
