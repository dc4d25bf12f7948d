#include "voronaut/planners/problem/planning_budget.h"

#include <chrono>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/problem/problem.h"

namespace voronaut {
namespace {

using Counts = PlanningBudget::Counts;
using Stop = PlanningBudget::Stop;

const ProblemConfig kConfig{.bounds_world = {{0, 0}, {10, 10}}, .goal_world = {9, 9}};

TEST(BudgetMeter, SaysWhichLimitWasMet) {
  std::uint64_t checks = 17;  // made before
  const BudgetMeter by_checks({.state_checks = 3, .ptc_evaluations = 100}, [&] { return checks; });
  const auto spent = by_checks.condition();
  EXPECT_FALSE(spent());
  EXPECT_FALSE(by_checks.ran_out());
  checks += 3;
  EXPECT_FALSE(by_checks.ran_out());  // nobody has asked
  EXPECT_TRUE(spent());
  EXPECT_EQ(by_checks.ran_out(), SolveEnd::state_checks);

  const BudgetMeter capped({.state_checks = 3, .ptc_evaluations = 5}, [] { return 0; });
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(capped.condition()());
  EXPECT_TRUE(capped.condition()());
  EXPECT_EQ(capped.ran_out(), SolveEnd::ptc_evaluations);
}

TEST(BudgetMeter, CountsIterationsWhateverTheyCheck) {
  std::uint64_t checks = 0;
  const BudgetMeter meter({.counts = Counts::iterations, .state_checks = 1, .iterations = 4},
                          [&] { return checks += 1000; });
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(meter.condition()());
  EXPECT_TRUE(meter.condition()());
  EXPECT_EQ(meter.ran_out(), SolveEnd::iterations);
}

TEST(BudgetMeter, EndsOnTheWallClock) {
  const BudgetMeter meter({.counts = Counts::wall_clock, .wall_clock_s = 0.05}, [] { return 0; });
  const auto start = std::chrono::steady_clock::now();
  const auto spent = meter.condition();
  while (!spent()) {
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_GT(taken.count(), 0.04);
  EXPECT_EQ(meter.ran_out(), SolveEnd::wall_clock);
}

TEST(BudgetMeter, StaysSpent) {
  std::uint64_t checks = 0;
  const BudgetMeter meter({.state_checks = 3}, [&] { return checks; });
  checks = 5;
  EXPECT_TRUE(meter.condition()());
  checks = 0;
  EXPECT_TRUE(meter.condition()());
}

struct Solved {
  SolveReport report;
  double length_m = std::nan("");
  std::uint64_t checks = 0;
};

Solved solve(const std::string& name, const PlanningBudget& budget) {
  PlanningProblem problem(kConfig);
  problem.update(ObstacleSnapshot{}, {1, 1});
  const auto planner = PlannerCatalog::built_in().find(name)->make(problem.space_information());
  planner->setProblemDefinition(problem.definition());
  Solved solved{solve_within(*planner, problem.meter(budget))};
  if (problem.definition()->hasSolution())
    solved.length_m = problem.definition()->getSolutionPath()->length();
  solved.checks = problem.state_checks();
  return solved;
}

// Class by class: a planner that stops by itself, one that obeys the cost threshold, two that
// ignore it.
TEST(SolveWithin, StopsAnAnytimePlannerAtItsFirstSolutionIfTold) {
  for (const char* name : {"RRTstar", "BITstar", "LBTRRT", "LazyLBTRRT", "LazyPRMstar"}) {
    const Solved first = solve(name, {.state_checks = 3000, .stop = Stop::first});
    EXPECT_EQ(first.report.status, ompl::base::PlannerStatus::EXACT_SOLUTION) << name;
    EXPECT_EQ(first.report.end, SolveEnd::first_solution) << name;
    EXPECT_LT(first.checks, 2000U) << name;
  }
}

TEST(SolveWithin, LetsAnAnytimePlannerUseItsWholeBudgetIfTold) {
  // One that never knows that it is done: BIT* ends by itself where the straight way is free.
  const Solved whole =
      solve("RRTstar", {.state_checks = 3000, .ptc_evaluations = 9000, .stop = Stop::budget});
  EXPECT_EQ(whole.report.status, ompl::base::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(whole.report.end == SolveEnd::state_checks ||
              whole.report.end == SolveEnd::ptc_evaluations);
  const Solved first = solve("RRTstar", {.state_checks = 3000, .stop = Stop::first});
  EXPECT_LE(whole.length_m, first.length_m);
}

TEST(SolveWithin, SaysThatAPlannerEndedByItself) {
  for (const Stop stop : {Stop::first, Stop::budget}) {
    const Solved solved = solve("RRTConnect", {.stop = stop});
    EXPECT_EQ(solved.report.status, ompl::base::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(solved.report.end, SolveEnd::planner);
  }
}

}  // namespace
}  // namespace voronaut
