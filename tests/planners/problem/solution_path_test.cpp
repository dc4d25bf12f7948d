#include "voronaut/planners/problem/solution_path.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/navigation/plan_request.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/tests/planners/mapping/known_points.h"

namespace voronaut {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Status = ob::PlannerStatus;

// Answers with the path and the status that it is told.
class Told : public ob::Planner {
 public:
  explicit Told(const ob::SpaceInformationPtr& si) : Planner(si, "Told") {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition&) override {
    if (points.empty()) return status;
    const auto path = std::make_shared<og::PathGeometric>(si_);
    ob::ScopedState<> state(si_);
    for (const Vec2& p : points) {
      set_position(*si_->getStateSpace(), state.get(), p);
      path->append(state.get());
    }
    pdef_->addSolutionPath(path, status == Status::APPROXIMATE_SOLUTION, 0, getName());
    return status;
  }

  std::vector<Vec2> points;
  Status::StatusType status = Status::EXACT_SOLUTION;
};

// From (1, 1) to (9, 9), a known point in the middle.
class SolutionPathAsked : public ::testing::Test {
 protected:
  SolutionPathAsked() { problem_.update(base_->snapshot(), {1, 1}); }

  PlanStatus asked(Status::StatusType status, const std::vector<Vec2>& points,
                   bool reactive = false) {
    planner_->points = points;
    planner_->status = status;
    problem_.update(base_->snapshot(), {1, 1});
    return ask_for_plan(*planner_, PlannerTraits{.plans_on_every_scan = reactive}, problem_, {})
        .status;
  }

 private:
  std::unique_ptr<ObstacleBase> base_ = test::base_of({{5, 5}});
  PlanningProblem problem_{{.bounds_world = {{0, 0}, {10, 10}}, .goal_world = {9, 9}}};
  std::shared_ptr<Told> planner_ = std::make_shared<Told>(problem_.space_information());
};

TEST_F(SolutionPathAsked, IsAnExactOneOrAnApproximateOneThatReachesTheGoal) {
  EXPECT_EQ(asked(Status::EXACT_SOLUTION, {{1, 1}, {1, 9}, {9, 9}}), PlanStatus::to_goal);
  EXPECT_EQ(asked(Status::APPROXIMATE_SOLUTION, {{1, 1}, {1, 9}, {9, 9}}), PlanStatus::to_goal);
  EXPECT_EQ(asked(Status::APPROXIMATE_SOLUTION, {{1, 1}, {1, 9}, {8.9, 9}}), PlanStatus::to_goal)
      << "within the goal's tolerance";
  EXPECT_EQ(asked(Status::APPROXIMATE_SOLUTION, {{1, 1}, {1, 9}, {8, 9}}), PlanStatus::none);
  EXPECT_EQ(asked(Status::APPROXIMATE_SOLUTION, {{1, 1}, {9, 9}}), PlanStatus::none)
      << "through the point";
  EXPECT_EQ(asked(Status::TIMEOUT, {{1, 1}, {1, 9}, {9, 9}}), PlanStatus::none);
}

TEST_F(SolutionPathAsked, OfAReactivePlannerIsItsNextLeg) {
  EXPECT_EQ(asked(Status::APPROXIMATE_SOLUTION, {{1, 1}, {1, 9}}, true), PlanStatus::partial);
}

TEST_F(SolutionPathAsked, ThatIsClaimedButNotThereIsThePlannersFault) {
  EXPECT_THROW(asked(Status::EXACT_SOLUTION, {}), std::runtime_error);
  EXPECT_THROW(asked(Status::APPROXIMATE_SOLUTION, {}, true), std::runtime_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(asked(Status::EXACT_SOLUTION, {{1, 1}, {1, nan}, {9, 9}}), std::runtime_error);
}

}  // namespace
}  // namespace voronaut
