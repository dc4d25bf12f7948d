#include "voronaut/planners/rollout/rollout_planner.h"

#include <algorithm>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/util/Exception.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// A goal region may offer goals without end.
constexpr std::size_t kMostGoals = 4;

}  // namespace

RolloutPlanner::RolloutPlanner(const ob::SpaceInformationPtr& si, const std::string& name)
    : Planner(si, name) {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.approximateSolutions = true;
  specs_.directed = true;
}

RolloutPlanner::~RolloutPlanner() { forget_rollouts(); }

void RolloutPlanner::setup() {
  Planner::setup();
  if (!has_position(*si_->getStateSpace()))
    throw ompl::Exception(getName(),
                          "plans in the plane: RealVectorStateSpace(2) or SE2StateSpace");
}

void RolloutPlanner::clear() {
  Planner::clear();
  forget_rollouts();
}

void RolloutPlanner::forget_rollouts() {
  attempts_.clear();
  for (ob::State* state : starts_) si_->freeState(state);
  for (ob::State* state : goals_) si_->freeState(state);
  starts_.clear();
  goals_.clear();
}

ob::PlannerStatus RolloutPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  if (!dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get()))
    return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  while (const ob::State* start = pis_.nextStart()) starts_.push_back(si_->cloneState(start));
  if (starts_.empty()) return ob::PlannerStatus::INVALID_START;
  if (!read_goals(ptc)) return ob::PlannerStatus::INVALID_GOAL;

  do {
    if (!latest() || latest()->status() == Rollout::Status::stuck) {
      if (!begin_attempt()) break;
    }
    Rollout& rollout = *attempts_.back().rollout;
    while (rollout.status() == Rollout::Status::running && !ptc) rollout.advance();
  } while (latest()->status() == Rollout::Status::stuck && !ptc);
  return report();
}

bool RolloutPlanner::read_goals(const ob::PlannerTerminationCondition& ptc) {
  if (goals_.empty()) {
    if (const ob::State* goal = pis_.nextGoal(ptc)) goals_.push_back(si_->cloneState(goal));
  }
  while (goals_.size() < kMostGoals && pis_.haveMoreGoalStates()) {
    const ob::State* goal = pis_.nextGoal();
    if (!goal) break;
    goals_.push_back(si_->cloneState(goal));
  }
  return !goals_.empty();
}

bool RolloutPlanner::begin_attempt() {
  for (std::size_t start = 0; start < starts_.size(); ++start) {
    for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
      const bool tried = std::any_of(attempts_.begin(), attempts_.end(), [&](const Attempt& each) {
        return each.start == start && each.goal == goal;
      });
      if (tried) continue;
      attempts_.push_back({start, goal, make_rollout(starts_[start], goals_[goal])});
      return true;
    }
  }
  return false;
}

ob::PlannerStatus RolloutPlanner::report() const {
  const auto best =
      std::min_element(attempts_.begin(), attempts_.end(), [](const Attempt& a, const Attempt& b) {
        return a.rollout->closest_m() < b.rollout->closest_m();
      });
  const Rollout& rollout = *best->rollout;
  const bool exact = rollout.status() == Rollout::Status::at_goal;
  const std::size_t end =
      exact ? rollout.path().getStateCount() - 1 : end_of_approximation(rollout);
  if (!exact && end == 0) return ob::PlannerStatus::TIMEOUT;
  auto path = std::make_shared<og::PathGeometric>(si_);
  for (std::size_t i = 0; i <= end; ++i)
    path->append(rollout.path().getState(static_cast<unsigned>(i)));
  const Vec2 end_world = position_of(*si_->getStateSpace(), path->getStates().back());
  pdef_->addSolutionPath(path, !exact, (rollout.goal_world() - end_world).norm(), getName());
  return {true, !exact};
}

std::size_t RolloutPlanner::end_of_approximation(const Rollout& rollout) const {
  return rollout.closest_index();
}

void RolloutPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  for (const Attempt& attempt : attempts_) {
    const og::PathGeometric& way = attempt.rollout->path();
    add_chain(way, data);
    if (attempt.rollout->status() == Rollout::Status::at_goal)
      data.markGoalState(way.getState(static_cast<unsigned>(way.getStateCount() - 1)));
  }
}

void add_chain(const og::PathGeometric& path, ob::PlannerData& data) {
  const auto state = [&](std::size_t i) { return path.getState(static_cast<unsigned>(i)); };
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    if (i == 0)
      data.addStartVertex(ob::PlannerDataVertex(state(0)));
    else
      data.addEdge(ob::PlannerDataVertex(state(i - 1)), ob::PlannerDataVertex(state(i)));
  }
}

}  // namespace voronaut
