#pragma once

#include <memory>

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/PathGeometric.h>

// A planner that knows nothing of Voronaut: straight to the goal, or nothing.
class StraightLine : public ompl::base::Planner {
 public:
  explicit StraightLine(const ompl::base::SpaceInformationPtr& si) : Planner(si, "StraightLine") {
    specs_.recognizedGoal = ompl::base::GOAL_SAMPLEABLE_REGION;
  }

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override {
    checkValidity();
    const ompl::base::State* start = pis_.nextStart();
    if (start == nullptr) return ompl::base::PlannerStatus::INVALID_START;
    const ompl::base::State* goal = pis_.nextGoal(ptc);
    if (goal == nullptr) return ompl::base::PlannerStatus::INVALID_GOAL;
    if (!si_->checkMotion(start, goal)) return ompl::base::PlannerStatus::TIMEOUT;
    pdef_->addSolutionPath(std::make_shared<ompl::geometric::PathGeometric>(si_, start, goal),
                           false, 0, getName());
    return ompl::base::PlannerStatus::EXACT_SOLUTION;
  }
};
