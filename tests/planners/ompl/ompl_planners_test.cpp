#include "voronaut/planners/ompl/ompl_planners.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>

#include "voronaut/planners/navigation/plan_request.h"
#include "voronaut/tests/planners/mapping/known_points.h"

// What docs/ompl.md says of planners of OMPL 1.5.2 that abort, find nothing or have no memory as
// they are. Each solves many times over: a new seed every time.
namespace voronaut {
namespace {

namespace ob = ompl::base;
using test::base_of;

constexpr double kClearance_m = 0.4;
const Vec2 kStart(1, 5);

// A wall of points across the straight way, from `low_m` up by four metres.
std::vector<Vec2> wall(double low_m) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 20; ++i) points.emplace_back(5, low_m + 0.2 * i);
  return points;
}

struct Asked {
  explicit Asked(const std::string& name, const Vec2& goal = {9, 5})
      : problem({.bounds_world = {{0, 0}, {10, 10}},
                 .goal_world = goal,
                 .planning_clearance_m = kClearance_m}),
        entry(*catalog.find(name)),
        planner(entry.make(problem.space_information())) {}

  Plan plan(const ObstacleSnapshot& known, std::uint64_t state_checks = 2000) {
    problem.update(known, kStart);
    return ask_for_plan(*planner, entry.traits, problem,
                        {.state_checks = state_checks, .ptc_evaluations = 4 * state_checks});
  }
  // Who found it, in OMPL's words.
  std::string finder() const { return problem.definition()->getSolutions().front().plannerName_; }

  PlannerCatalog catalog = PlannerCatalog::built_in();
  PlanningProblem problem;
  const PlannerEntry& entry;
  ob::PlannerPtr planner;
};

// As a flight asks: again and again, from where it is by then.
TEST(EveryPlanner, PlansAnewWhenItIsAskedAgain) {
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) {
    if (entry->traits.plans_on_every_scan) continue;
    // Ten times what nearly all solves need: one in 200 of XXL's asks 6000 times whether to end.
    PlanningBudget budget{
        .state_checks = 30'000, .ptc_evaluations = 60'000, .stop = PlanningBudget::Stop::first};
    // Threads that wait for a solution ask for the end all the time: those get a clock.
    if (entry->traits.reproducible == Reproducible::no)
      budget.counts = PlanningBudget::Counts::wall_clock;
    budget.wall_clock_s = 60;  // however slow the machine
    Asked asked(entry->name);
    for (const Vec2& start : {Vec2(1, 5), Vec2(2, 4), Vec2(3, 6)}) {
      asked.problem.update(ObstacleSnapshot{}, start);
      const Plan plan = ask_for_plan(*asked.planner, entry->traits, asked.problem, budget);
      ASSERT_NE(plan.status, PlanStatus::refused) << entry->name << ": " << plan.refusal;
      // Its steps have a random length and seldom end within the tolerance.
      if (entry->name == "SST" && plan.status == PlanStatus::none) continue;
      ASSERT_EQ(plan.status, PlanStatus::to_goal) << entry->name << " from " << start.transpose();
      EXPECT_EQ(plan.path.front(), start) << entry->name;
      EXPECT_EQ(plan.path.back(), Vec2(9, 5)) << entry->name;
    }
  }
}

// Slanting, so that the lengths of parts of the straight way are rounded.
TEST(AITstar, ImprovesItsPathThroughAnEmptySquareWithoutAborting) {
  Asked ait("AITstar", {8.765432, 6.54321});
  for (int solve = 0; solve < 2; ++solve)
    EXPECT_EQ(ait.plan(ObstacleSnapshot{}, 3000).status, PlanStatus::to_goal);
}

// Its shortest path ends where the goal's tolerance begins, and whoever stops there has not
// arrived.
TEST(AITstar, IsLedOnToTheGoalItself) {
  Asked ait("AITstar", {8.765432, 6.54321});
  const Plan plan = ait.plan(ObstacleSnapshot{}, 1000);
  ASSERT_EQ(plan.status, PlanStatus::to_goal);
  EXPECT_EQ(plan.path.back(), Vec2(8.765432, 6.54321));
}

TEST(LazyLBTRRT, FindsBlockedMotionsAtItsStartWithoutAborting) {
  std::vector<Vec2> points = wall(3);
  for (const Vec2& beside : {Vec2(1.6, 5), Vec2(1, 5.6), Vec2(1, 4.4)}) points.push_back(beside);
  const auto base = base_of(points);
  Asked lazy("LazyLBTRRT");
  for (int solve = 0; solve < 20; ++solve)
    EXPECT_EQ(lazy.plan(base->snapshot()).status, PlanStatus::to_goal);
}

TEST(LazyLBTRRT, MayBeClearedTwiceAndDestroyedAfterwards) {
  Asked lazy("LazyLBTRRT");
  EXPECT_EQ(lazy.plan(ObstacleSnapshot{}).status, PlanStatus::to_goal);
  lazy.planner->clear();
  lazy.planner->clear();
}

TEST(VFRRT, ReachesAGoalWithinALargeRangeOfItsOwn) {
  const auto base = base_of(wall(3));
  Asked field("VFRRT");
  int reached = 0;
  for (int solve = 0; solve < 20; ++solve)
    reached += field.plan(base->snapshot()).status == PlanStatus::to_goal ? 1 : 0;
  EXPECT_GE(reached, 18);
}

class ExperiencePlanner : public testing::TestWithParam<std::string> {};

TEST_P(ExperiencePlanner, RecallsWhatItPlannedFromScratch) {
  const auto base = base_of(wall(3));
  Asked experienced(GetParam());
  ASSERT_EQ(experienced.plan(base->snapshot()).status, PlanStatus::to_goal);
  EXPECT_EQ(experienced.finder(), "RRTConnect");
  ASSERT_EQ(experienced.plan(base->snapshot()).status, PlanStatus::to_goal);
  EXPECT_EQ(experienced.finder(), GetParam());
}

TEST_P(ExperiencePlanner, PassesWhatHasAppearedOnItsEarlierPaths) {
  Asked experienced(GetParam());
  for (const double low_m : {3.0, 0.5, 5.5, 2.0, 4.0}) {
    const auto base = base_of(wall(low_m));
    const Plan plan = experienced.plan(base->snapshot());
    ASSERT_EQ(plan.status, PlanStatus::to_goal) << "wall from " << low_m;
    for (const PathSegment& leg : plan.path.segments())
      for (const Vec2& point : wall(low_m))
        EXPECT_GE(distance(point, Segment{leg.start, leg.end}), kClearance_m - 1e-9);
  }
}

TEST_P(ExperiencePlanner, TellsWhatItLookedAtAfterItIsCleared) {
  Asked experienced(GetParam());
  ASSERT_EQ(experienced.plan(ObstacleSnapshot{}).status, PlanStatus::to_goal);
  ASSERT_EQ(experienced.plan(ObstacleSnapshot{}).status, PlanStatus::to_goal);
  EXPECT_FALSE(experienced.problem.searched_edges(*experienced.planner).empty());
  experienced.planner->clear();
  ob::PlannerData data(experienced.problem.space_information());
  experienced.planner->getPlannerData(data);
}

TEST_P(ExperiencePlanner, RefusesAnInvalidStartLikeOthers) {
  const auto base = base_of({{5, 5}});
  Asked experienced(GetParam());
  ASSERT_EQ(experienced.plan(ObstacleSnapshot{}).status, PlanStatus::to_goal);
  experienced.problem.update(base->snapshot(), {-1, 5});
  EXPECT_EQ(
      ask_for_plan(*experienced.planner, experienced.entry.traits, experienced.problem, {}).status,
      PlanStatus::refused);
}

INSTANTIATE_TEST_SUITE_P(Ompl, ExperiencePlanner,
                         testing::Values("LightningRetrieveRepair", "ThunderRetrieveRepair"),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace voronaut
