#include "voronaut/benchmarks/suite/acceptance_criterion.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

RunRecord record(const std::string& planner, Outcome outcome, double clearance_m,
                 double path_ratio = kAbsent) {
  RunRecord record;
  record.planner = planner;
  record.scenario_group = "wood";
  record.vehicle = "ideal";
  record.outcome = outcome;
  record.clearance_smallest_m = clearance_m;
  record.path_ratio = path_ratio;
  return record;
}

// Two planners: one arrives three times in four and hits something once, the other always arrives.
std::vector<RunRecord> records() {
  return {record("a", Outcome::goal_reached, 0.4, 1.0),
          record("a", Outcome::goal_reached, 0.3, 1.2),
          record("a", Outcome::goal_reached, 0.5, 1.1), record("a", Outcome::collision, 0.2),
          record("b", Outcome::goal_reached, 0.6, 1.0)};
}

TEST(AcceptanceCriterion, CountsFailuresInTheDenominator) {
  AcceptanceCriterion criterion;
  criterion.planner = "a";
  criterion.bound("goal_reached_share_min") = 0.75;
  const Finding held = examine(criterion, records());
  EXPECT_TRUE(held.holds);
  EXPECT_EQ(held.text, "a: goal reached >= 75 % (3 of 4)");
  criterion.bound("goal_reached_share_min") = 0.76;
  EXPECT_FALSE(examine(criterion, records()).holds);
}

TEST(AcceptanceCriterion, IsAboutEveryTrialUnlessItSaysWhich) {
  AcceptanceCriterion criterion;
  criterion.bound("collision_share_max") = 0;
  criterion.bound("clearance_smallest_m_min") = 0.25;
  const Finding broken = examine(criterion, records());
  EXPECT_FALSE(broken.holds);
  EXPECT_EQ(broken.text,
            "every trial: collisions <= 0 % (1 of 5); clearance smallest >= 0.25 m (0.200 m)");
  criterion.planner = "b";
  criterion.vehicle = "ideal";
  criterion.group = "wood";
  EXPECT_EQ(examine(criterion, records()).text,
            "b, ideal, wood: collisions <= 0 % (0 of 1); clearance smallest >= 0.25 m (0.600 m)");
  EXPECT_TRUE(examine(criterion, records()).holds);
}

TEST(AcceptanceCriterion, IsBrokenWithoutATrialItIsAbout) {
  AcceptanceCriterion criterion;
  criterion.planner = "nobody";
  EXPECT_FALSE(examine(criterion, records()).holds);
  EXPECT_EQ(examine(criterion, records()).text, "nobody: no such trial");
}

TEST(AcceptanceCriterion, JudgesPathRatiosOverManyArrivalsOnly) {
  AcceptanceCriterion criterion;
  criterion.planner = "a";
  criterion.bound("path_ratio_mean_max") = 1.05;
  const Finding few = examine(criterion, records());
  EXPECT_TRUE(few.holds);
  EXPECT_EQ(few.text, "a: path ratio mean <= 1.05 (1.100 over 3: too few to judge)");
  std::vector<RunRecord> many;
  for (int i = 0; i < 40; ++i)
    for (const RunRecord& one : records()) many.push_back(one);
  EXPECT_FALSE(examine(criterion, many).holds);
  criterion.bound("path_ratio_mean_max") = 1.11;
  EXPECT_TRUE(examine(criterion, many).holds);
  criterion.bound("path_ratio_p95_max") = 1.19;
  const Finding tail = examine(criterion, many);
  EXPECT_FALSE(tail.holds);
  EXPECT_EQ(
      tail.text,
      "a: path ratio mean <= 1.11 (1.100 over 120); path ratio 95th percentile <= 1.19 (1.200 over "
      "120)");
}

TEST(AcceptanceCriterion, AllHoldOnlyIfEachDoesAndWhoWasLeftOutIsNotJudged) {
  AcceptanceCriterion broken, kept, absent, beside;
  broken.bound("clearance_smallest_m_min") = 1e6;
  absent.planner = "nobody";
  beside.speed_beside = "nobody";
  beside.speed_ratio_min = 1;
  EXPECT_TRUE(examine_all({kept}, {"a"}, records()).holds);
  EXPECT_FALSE(examine_all({broken, kept}, {"a"}, records()).holds) << "whatever comes after it";
  EXPECT_FALSE(examine_all({kept, broken}, {"a"}, records()).holds);
  const Finding left_out = examine_all({absent, beside, kept}, {"a"}, records());
  EXPECT_TRUE(left_out.holds);
  EXPECT_EQ(left_out.text,
            "  not judged: nobody was left out\n  not judged: nobody was left out\n"
            "  holds: every trial:\n");
  EXPECT_FALSE(examine_all({absent}, {"nobody"}, records()).holds) << "flew, and has no trial";
}

TEST(AcceptanceCriterion, JudgesPathsAgainstTheShortestAtTheClearanceThatPlannersKeep) {
  std::vector<RunRecord> many;
  for (int i = 0; i < 120; ++i) many.push_back(records().front());
  for (RunRecord& one : many) {
    one.path_ratio = 1.5;
    one.shortest_length_m = 10;
    one.shortest_at_clearance_m = 12;
  }
  AcceptanceCriterion criterion;
  criterion.bound("path_ratio_at_clearance_mean_max") = 1.26;
  EXPECT_TRUE(examine(criterion, many).holds);
  EXPECT_EQ(examine(criterion, many).text,
            "every trial: path ratio at planning_clearance_m mean <= 1.26 (1.250 over 120)");
  criterion.bound("path_ratio_at_clearance_mean_max") = 1.2;
  EXPECT_FALSE(examine(criterion, many).holds);
}

TEST(AcceptanceCriterion, ComparesSpeedsInWorldsThatBothFinished) {
  std::vector<RunRecord> flights;
  for (int world = 0; world < 200; ++world) {
    for (const char* planner : {"careful", "bold"}) {
      RunRecord flight = record(planner, Outcome::goal_reached, 0.4, 1.0);
      flight.repetition = world;
      flight.speed_mean_m_s = planner[0] == 'c' ? 1.8 : 2;
      // Where the bold one fails, the careful one is slow: no pair.
      if (world % 2 == 0) {
        if (planner[0] == 'b') flight.outcome = Outcome::collision;
        flight.speed_mean_m_s = 1;
      }
      flights.push_back(flight);
    }
  }
  AcceptanceCriterion criterion;
  criterion.planner = "careful";
  criterion.speed_beside = "bold";
  criterion.speed_ratio_min = 0.89;
  EXPECT_TRUE(examine(criterion, flights).holds);
  EXPECT_EQ(examine(criterion, flights).text,
            "careful: mean speed >= 0.89 x bold (0.900 over 100)");
  criterion.speed_ratio_min = 0.91;
  EXPECT_FALSE(examine(criterion, flights).holds);
  criterion.speed_beside = "nobody";
  EXPECT_FALSE(examine(criterion, flights).holds);
}

// Ratios of 0.98 and 1.02 by turns: 1 in the mean, and 1.96 x 0.02 / sqrt(100) less at its lower
// end.
TEST(AcceptanceCriterion, BoundsTheLowerEndOfASpeedRatio) {
  std::vector<RunRecord> flights;
  for (int world = 0; world < 100; ++world) {
    for (const char* planner : {"careful", "bold"}) {
      RunRecord flight = record(planner, Outcome::goal_reached, 0.4, 1.0);
      flight.repetition = world;
      flight.speed_mean_m_s = planner[0] == 'b' ? 2 : world % 2 == 0 ? 1.96 : 2.04;
      flights.push_back(flight);
    }
  }
  AcceptanceCriterion criterion;
  criterion.planner = "careful";
  criterion.speed_beside = "bold";
  criterion.speed_ratio_min = 0.99;
  criterion.speed_ratio_lower_min = 0.995;
  EXPECT_TRUE(examine(criterion, flights).holds);
  EXPECT_EQ(examine(criterion, flights).text,
            "careful: mean speed >= 0.99 x bold (1.000 over 100); its lower bound >= 0.995 x bold "
            "(0.996 over 100)");
  criterion.speed_ratio_lower_min = 0.997;
  EXPECT_FALSE(examine(criterion, flights).holds);
}

TEST(AcceptanceCriterion, BoundsEveryStatisticWhereItCanBeWorse) {
  for (const Statistic& one : statistics()) {
    AcceptanceCriterion criterion;
    const std::string name(one.name);
    if (one.better != Better::less) {
      EXPECT_NO_THROW(criterion.bound(name + "_min"));
    }
    if (one.better != Better::more) {
      EXPECT_NO_THROW(criterion.bound(name + "_max"));
    }
  }
  AcceptanceCriterion criterion;
  EXPECT_THROW(criterion.bound("collision_share_min"), std::invalid_argument);
  EXPECT_EQ(examine(criterion, records()).text, "every trial:") << "demands nothing";
  criterion.bound("infeasible_share_min") = 1;
  EXPECT_EQ(examine(criterion, records()).text, "every trial: infeasible >= 100 % (0 of 5)");
  EXPECT_FALSE(examine(criterion, records()).holds);
}

TEST(AcceptanceCriterion, IsBrokenWhereNoTrialHasWhatItBounds) {
  AcceptanceCriterion criterion;
  criterion.bound("path_ratio_mean_max") = 2;
  const Finding finding = examine(criterion, {record("a", Outcome::collision, 0.2)});
  EXPECT_FALSE(finding.holds);
  EXPECT_EQ(finding.text,
            "every trial: path ratio mean <= 2 (over none of the trials that reached the goal)");
}

}  // namespace
}  // namespace voronaut
