#include "voronaut/benchmarks/suite/claim.h"

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
  record.clearance_min_m = clearance_m;
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

TEST(Claim, CountsFailuresInTheDenominator) {
  Claim claim;
  claim.planner = "a";
  claim.outcome_share_min = 0.75;
  const Finding held = examine(claim, records());
  EXPECT_TRUE(held.holds);
  EXPECT_EQ(held.text, "a: goal_reached >= 75 % (3 of 4)");
  claim.outcome_share_min = 0.76;
  EXPECT_FALSE(examine(claim, records()).holds);
}

TEST(Claim, IsAboutEveryTrialUnlessItSaysWhich) {
  Claim claim;
  claim.collision_share_max = 0;
  claim.clearance_min_m = 0.25;
  const Finding broken = examine(claim, records());
  EXPECT_FALSE(broken.holds);
  EXPECT_EQ(broken.text, "every trial: collisions <= 0 % (1 of 5); clearance >= 0.25 m (0.2 m)");
  claim.planner = "b";
  claim.vehicle = "ideal";
  claim.group = "wood";
  EXPECT_EQ(examine(claim, records()).text,
            "b, ideal, wood: collisions <= 0 % (0 of 1); clearance >= 0.25 m (0.6 m)");
  EXPECT_TRUE(examine(claim, records()).holds);
}

TEST(Claim, IsBrokenWithoutATrialItIsAbout) {
  Claim claim;
  claim.planner = "nobody";
  EXPECT_FALSE(examine(claim, records()).holds);
  EXPECT_EQ(examine(claim, records()).text, "nobody: no such trial");
}

TEST(Claim, JudgesPathRatiosOverManyArrivalsOnly) {
  Claim claim;
  claim.planner = "a";
  claim.path_ratio_mean_max = 1.05;
  const Finding few = examine(claim, records());
  EXPECT_TRUE(few.holds);
  EXPECT_EQ(few.text, "a: mean path ratio <= 1.05 (1.1 over 3: too few to judge)");
  std::vector<RunRecord> many;
  for (int i = 0; i < 40; ++i)
    for (const RunRecord& one : records()) many.push_back(one);
  EXPECT_FALSE(examine(claim, many).holds);
  claim.path_ratio_mean_max = 1.11;
  EXPECT_TRUE(examine(claim, many).holds);
  claim.path_ratio_p95_max = 1.19;
  const Finding tail = examine(claim, many);
  EXPECT_FALSE(tail.holds);
  EXPECT_EQ(
      tail.text,
      "a: mean path ratio <= 1.11 (1.1 over 120); 95 % of path ratios <= 1.19 (1.2 over 120)");
}

TEST(Claim, JudgesPathsAgainstTheShortestAtTheClearanceThatPlannersKeep) {
  std::vector<RunRecord> many;
  for (int i = 0; i < 120; ++i) many.push_back(records().front());
  for (RunRecord& one : many) {
    one.path_ratio = 1.5;
    one.shortest_length_m = 10;
    one.shortest_at_clearance_m = 12;
  }
  Claim claim;
  claim.path_ratio_at_clearance_mean_max = 1.26;
  EXPECT_TRUE(examine(claim, many).holds);
  EXPECT_EQ(examine(claim, many).text,
            "every trial: mean path ratio at clearance_min_m <= 1.26 (1.25 over 120)");
  claim.path_ratio_at_clearance_mean_max = 1.2;
  EXPECT_FALSE(examine(claim, many).holds);
}

TEST(Claim, ComparesSpeedsInWorldsThatBothFinished) {
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
  Claim claim;
  claim.planner = "careful";
  claim.speed_beside = "bold";
  claim.speed_ratio_min = 0.89;
  EXPECT_TRUE(examine(claim, flights).holds);
  EXPECT_EQ(examine(claim, flights).text, "careful: mean speed >= 0.89 x bold (0.9 over 100)");
  claim.speed_ratio_min = 0.91;
  EXPECT_FALSE(examine(claim, flights).holds);
  claim.speed_beside = "nobody";
  EXPECT_FALSE(examine(claim, flights).holds);
}

}  // namespace
}  // namespace voronaut
