#pragma once

#include <map>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/tests/conformance/planar_problem.h"

// What OMPL's contract asks of a planner beyond a signature: after OMPL's own
// tests/base/PlannerTest and doc/markdown/newPlanner. Include it in one source of a test program
// and name the planners:
//   INSTANTIATE_TEST_SUITE_P(Mine, PlannerConformance, testing::Values(PlannerCase{...}),
//   case_name);
namespace voronaut::test {

struct PlannerCase {
  std::string name;
  std::function<ompl::base::PlannerPtr(const ompl::base::SpaceInformationPtr&)> make;
  Space space = Space::plane;
};

inline void PrintTo(const PlannerCase& planner, std::ostream* out) { *out << planner.name; }

inline const ompl::base::State* last_state(const ompl::geometric::PathGeometric& path) {
  return path.getState(static_cast<unsigned>(path.getStateCount() - 1));
}

inline std::string case_name(const testing::TestParamInfo<PlannerCase>& info) {
  return info.param.name;
}

class PlannerConformance : public testing::TestWithParam<PlannerCase> {
 protected:
  using Status = ompl::base::PlannerStatus;

  ompl::base::PlannerPtr planner_for(const PlanarProblem& problem,
                                     const ompl::base::ProblemDefinitionPtr& definition) const {
    ompl::base::PlannerPtr planner = GetParam().make(problem.si);
    planner->setProblemDefinition(definition);
    return planner;
  }

  static Status solve(ompl::base::Planner& planner, unsigned evaluations = 5000) {
    ompl::base::IterationTerminationCondition most(evaluations);
    return planner.solve(static_cast<ompl::base::PlannerTerminationCondition>(most));
  }

  static void expect_exact_path(const ompl::base::ProblemDefinition& definition, const Vec2& start,
                                const Vec2& goal) {
    ASSERT_TRUE(definition.hasExactSolution());
    const auto& path = *definition.getSolutionPath()->as<ompl::geometric::PathGeometric>();
    EXPECT_TRUE(path.check());
    const auto& si = *definition.getSpaceInformation();
    EXPECT_LT((planar(si, path.getState(0)) - start).norm(), 1e-9);
    EXPECT_LT((planar(si, last_state(path)) - goal).norm(), 1e-9);
  }

  const Vec2 start_{1, 1};
  const Vec2 goal_{9, 9};
  PlanarProblem open_{free_of_two_discs, GetParam().space};
};

TEST_P(PlannerConformance, SolvesWithAValidPathThatBearsItsName) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
  ompl::base::PlannerSolution solution(nullptr);
  ASSERT_TRUE(definition->getSolution(solution));
  EXPECT_EQ(solution.plannerName_, planner->getName());
  EXPECT_FALSE(solution.approximate_);
}

TEST_P(PlannerConformance, SolvesAgainWithoutBeingCleared) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  definition->clearSolutionPaths();
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
}

TEST_P(PlannerConformance, ReturnsAtOnceWhenToldToAndGoesOnLater) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  EXPECT_NE(planner->solve(ompl::base::plannerAlwaysTerminatingCondition()),
            Status::EXACT_SOLUTION);
  Status status = Status::UNKNOWN;
  // Ever more, as OMPL's own test gives ever more time.
  for (unsigned budget = 10; budget <= 10'000 && status != Status::EXACT_SOLUTION; budget *= 10) {
    definition->clearSolutionPaths();
    status = solve(*planner, budget);
  }
  EXPECT_EQ(status, Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
}

TEST_P(PlannerConformance, ClearsAsOftenAsAsked) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  for (int round = 0; round < 3; ++round) {
    planner->clear();
    planner->clear();
    definition->clearSolutionPaths();
    EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  }
}

TEST_P(PlannerConformance, EndsWhereOnlyStartAndGoalAreValid) {
  const PlanarProblem nowhere([this](const Vec2& p) { return p == start_ || p == goal_; },
                              GetParam().space);
  const auto definition = nowhere.define({start_}, {goal_});
  const auto planner = planner_for(nowhere, definition);
  EXPECT_NE(solve(*planner, 500), Status::EXACT_SOLUTION);
  EXPECT_FALSE(definition->hasExactSolution());
}

TEST_P(PlannerConformance, RefusesInvalidStartsAndGoals) {
  const Vec2 in_disc(5.3, 4.7);
  const auto bad_start = open_.define({in_disc}, {goal_});
  EXPECT_EQ(solve(*planner_for(open_, bad_start), 500), Status::INVALID_START);
  EXPECT_FALSE(bad_start->hasSolution());
  const auto bad_goal = open_.define({start_}, {in_disc});
  // OMPL's own differ: INVALID_GOAL, a timeout, an approximate solution.
  EXPECT_NE(solve(*planner_for(open_, bad_goal), 50), Status::EXACT_SOLUTION);
  EXPECT_FALSE(bad_goal->hasExactSolution());
}

TEST_P(PlannerConformance, RefusesGoalsItCannotSample) {
  struct Somewhere : ompl::base::Goal {
    using Goal::Goal;
    bool isSatisfied(const ompl::base::State*) const override { return false; }
  };
  const auto definition = open_.define({start_}, {goal_});
  definition->setGoal(std::make_shared<Somewhere>(open_.si));
  const auto planner = planner_for(open_, definition);
  if (planner->getSpecs().recognizedGoal != ompl::base::GOAL_SAMPLEABLE_REGION) GTEST_SKIP();
  EXPECT_EQ(solve(*planner, 500), Status::UNRECOGNIZED_GOAL_TYPE);
}

TEST_P(PlannerConformance, TakesTheStartFromWhichThereIsAWay) {
  const Vec2 enclosed(7, 2);
  const PlanarProblem problem(with_ring_around(enclosed), GetParam().space);
  const auto definition = problem.define({enclosed, start_}, {goal_});
  EXPECT_EQ(solve(*planner_for(problem, definition)), Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
}

TEST_P(PlannerConformance, TakesTheGoalToWhichThereIsAWay) {
  const Vec2 enclosed(8, 3);
  const PlanarProblem problem(with_ring_around(enclosed), GetParam().space);
  const auto definition = problem.define({start_}, {enclosed, goal_});
  EXPECT_EQ(solve(*planner_for(problem, definition)), Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
}

TEST_P(PlannerConformance, TakesInAGoalThatIsAddedLater) {
  const Vec2 enclosed(8, 3);
  const PlanarProblem problem(with_ring_around(enclosed), GetParam().space);
  const auto definition = problem.define({start_}, {enclosed});
  const auto planner = planner_for(problem, definition);
  EXPECT_NE(solve(*planner, 1000), Status::EXACT_SOLUTION);
  ompl::base::ScopedState<> more(problem.si);
  more[0] = goal_.x();
  more[1] = goal_.y();
  if (GetParam().space == Space::se2) more[2] = 0;
  definition->getGoal()->as<ompl::base::GoalStates>()->addState(more);
  definition->clearSolutionPaths();
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  expect_exact_path(*definition, start_, goal_);
}

TEST_P(PlannerConformance, SaysThatAnApproximateSolutionIsOne) {
  const PlanarProblem problem(with_ring_around(goal_ - Vec2(1, 1)), GetParam().space);
  const auto definition = problem.define({start_}, {goal_ - Vec2(1, 1)});
  const auto planner = planner_for(problem, definition);
  const Status status = solve(*planner, 2000);
  ASSERT_NE(status, Status::EXACT_SOLUTION);
  ASSERT_EQ(status == Status::APPROXIMATE_SOLUTION, definition->hasSolution());
  if (!definition->hasSolution()) return;
  EXPECT_TRUE(definition->hasApproximateSolution());
  const auto& path = *definition->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  EXPECT_TRUE(path.check());
  const auto& goal = *definition->getGoal()->as<ompl::base::GoalRegion>();
  const double short_of_goal = goal.distanceGoal(last_state(path));
  EXPECT_NEAR(definition->getSolutionDifference(), short_of_goal, 1e-6);
}

TEST_P(PlannerConformance, ShowsWhatItExploredAndNothingAfterClear) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  ASSERT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  ompl::base::PlannerData data(open_.si);
  planner->getPlannerData(data);
  EXPECT_GE(data.numVertices(), 2u);
  EXPECT_GE(data.numEdges(), 1u);
  EXPECT_GE(data.numStartVertices(), 1u);
  EXPECT_GE(data.numGoalVertices(), 1u);
  for (unsigned i = 0; i < data.numVertices(); ++i)
    EXPECT_TRUE(open_.si->isValid(data.getVertex(i).getState()));
  planner->clear();
  ompl::base::PlannerData nothing(open_.si);
  planner->getPlannerData(nothing);
  EXPECT_EQ(nothing.numVertices(), 0u);
}

TEST_P(PlannerConformance, SolvesAnotherProblemAfterClear) {
  const auto first = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, first);
  ASSERT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  const auto second = open_.define({goal_}, {start_});
  planner->setProblemDefinition(second);
  planner->clear();
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  expect_exact_path(*second, goal_, start_);
}

TEST_P(PlannerConformance, SolvesAnotherQueryAfterClearQuery) {
  const auto first = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, first);
  ASSERT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  planner->clearQuery();
  const auto second = open_.define({goal_}, {start_});
  planner->setProblemDefinition(second);
  EXPECT_EQ(solve(*planner), Status::EXACT_SOLUTION);
  expect_exact_path(*second, goal_, start_);
}

// "name TYPE" -> a value at any time, as OMPL's Benchmark samples them.
TEST_P(PlannerConformance, HasProgressPropertiesOfAKnownType) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  planner->setup();
  const auto ask_all = [&] {
    for (const auto& [name, value] : planner->getPlannerProgressProperties()) {
      const std::string type = name.substr(name.rfind(' ') + 1);
      EXPECT_TRUE(type == "REAL" || type == "DOUBLE" || type == "INTEGER" || type == "BOOLEAN")
          << name;
      EXPECT_FALSE(value().empty()) << name;
    }
  };
  ask_all();
  solve(*planner);
  ask_all();
}

TEST_P(PlannerConformance, FreesEveryStateItAllocates) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  planner->setup();
  const long before = *open_.states_alive;
  for (int round = 0; round < 3; ++round) {
    solve(*planner);
    definition->clearSolutionPaths();
    planner->clear();
    EXPECT_EQ(*open_.states_alive, before) << "round " << round;
  }
}

TEST_P(PlannerConformance, KeepsItsParametersWhenCleared) {
  const auto definition = open_.define({start_}, {goal_});
  const auto planner = planner_for(open_, definition);
  std::map<std::string, std::string> before;
  std::map<std::string, std::string> after;
  planner->setup();
  planner->params().getParams(before);
  solve(*planner);
  planner->clear();
  planner->params().getParams(after);
  EXPECT_EQ(before, after);
}

}  // namespace voronaut::test
