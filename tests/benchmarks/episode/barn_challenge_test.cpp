#include "voronaut/benchmarks/episode/barn_challenge.h"

#include <cmath>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

// Along x: so many metres at so many seconds.
std::vector<Tick> ticks(std::initializer_list<std::pair<double, double>> t_and_x) {
  std::vector<Tick> list;
  for (const auto& [t_s, x_m] : t_and_x) {
    Tick tick;
    tick.t_s = t_s;
    tick.state.p_world.x() = x_m;
    list.push_back(tick);
  }
  return list;
}

RunRecord ended(Outcome outcome, double end_s) {
  RunRecord record;
  record.outcome = outcome;
  record.duration_s = end_s;
  return record;
}

TEST(BarnChallenge, StartsTheClockWhenTheRobotHasMovedTenCentimetres) {
  const auto flown = ticks({{0, 5}, {1, 5.09}, {2, 5.11}, {9, 15}});
  EXPECT_DOUBLE_EQ(barn_time_s(flown, 9), 7);
  EXPECT_TRUE(std::isnan(barn_time_s(ticks({{0, 5}, {9, 5.05}}), 9)));
}

TEST(BarnChallenge, ScoresATimeBetweenTwiceAndEightTimesTheBestOne) {
  struct Case {
    double time_s, score, pace;
  };
  for (const Case& c : {Case{20, 0.25, 0.25}, {5, 0.5, 1}, {10, 0.5, 0.5}, {41, 0.125, 5.0 / 41}}) {
    RunRecord record = ended(Outcome::goal_reached, c.time_s + 1);
    add_barn(record, ticks({{0, 0}, {1, 0.1}, {c.time_s + 1, 10}}), 10);  // best: 5 s
    EXPECT_DOUBLE_EQ(record.barn_time_s, c.time_s);
    EXPECT_DOUBLE_EQ(record.barn_score, c.score);
    EXPECT_DOUBLE_EQ(record.barn_pace, c.pace);
  }
}

TEST(BarnChallenge, GivesNothingForAFailureAndAllToWhoIsThereAlready) {
  RunRecord crashed = ended(Outcome::collision, 8);
  add_barn(crashed, ticks({{0, 0}, {8, 9}}), 10);
  EXPECT_EQ(crashed.barn_score, 0);
  EXPECT_TRUE(std::isnan(crashed.barn_pace));
  RunRecord there = ended(Outcome::goal_reached, 0);
  add_barn(there, ticks({{0, 0}}), 10);
  EXPECT_EQ(there.barn_score, 0.5);
}

}  // namespace
}  // namespace voronaut
