#include "voronaut/benchmarks/tuning/race.h"

#include <stdexcept>

#include <gmock/gmock.h>

namespace voronaut {
namespace {

using ::testing::HasSubstr;

RunRecord row(const std::string& planner, int world, double path_ratio, bool reached = true) {
  RunRecord record;
  record.planner = planner;
  record.scenario = "wood";
  record.repetition = world;
  record.vehicle = "v";
  record.outcome = reached ? Outcome::goal_reached : Outcome::collision;
  record.path_ratio = path_ratio;
  return record;
}

std::vector<const Statistic*> both() { return {&objective("success"), &objective("path_ratio")}; }

TEST(Race, RanksWithinEachWorldSoThatHardOnesCountAsMuchAsEasyOnes) {
  std::vector<RunRecord> rows;
  for (int world = 0; world < 10; ++world) {
    const double hard = world == 0 ? 100 : 1;  // the mean of the ratios would say the opposite
    rows.push_back(row("a", world, world == 0 ? 3 * hard : hard));
    rows.push_back(row("b", world, world == 0 ? hard : 1.5 * hard));
  }
  const auto standings = race({"b", "a"}, {&objective("path_ratio")}, rows, 1);
  EXPECT_EQ(standings[0].planner, "a");
  EXPECT_NEAR(standings[0].score, 0.1, 1e-12);
  EXPECT_NEAR(standings[1].score, 0.9, 1e-12);
  EXPECT_TRUE(standings[0].kept);
  EXPECT_FALSE(standings[1].kept);
}

TEST(Race, AFailureRanksLastWhateverItsPathWas) {
  std::vector<RunRecord> rows;
  for (int world = 0; world < 8; ++world) {
    rows.push_back(row("short", world, 0.5, false));
    rows.push_back(row("long", world, 2));
  }
  EXPECT_EQ(race({"short", "long"}, {&objective("path_ratio")}, rows, 1)[0].planner, "long");
}

TEST(Race, DropsWhoIsSurelyBehindThoughThereIsRoom) {
  std::vector<RunRecord> rows;
  for (int world = 0; world < 8; ++world) {
    rows.push_back(row("a", world, 1));
    rows.push_back(row("b", world, world % 2 == 0 ? 0.9 : 1.2));
    rows.push_back(row("c", world, 3));
  }
  const auto standings = race({"a", "b", "c"}, both(), rows, 3);
  EXPECT_TRUE(standings[0].kept);
  EXPECT_TRUE(standings[1].kept) << "nobody knows";
  EXPECT_EQ(standings[2].planner, "c");
  EXPECT_FALSE(standings[2].kept);
}

TEST(Race, OnFewWorldsDropsNobodyBeforeTheCut) {
  std::vector<RunRecord> rows;
  for (int world = 0; world < 5; ++world)
    for (const char* planner : {"a", "b", "c"})
      rows.push_back(row(planner, world, planner[0] - 'a' + 1));
  const auto standings = race({"c", "b", "a"}, both(), rows, 2);
  EXPECT_EQ(standings[0].planner, "a");
  EXPECT_TRUE(standings[1].kept);
  EXPECT_FALSE(standings[2].kept);
}

TEST(Race, TiesGoToWhoIsNamedFirst) {
  std::vector<RunRecord> rows;
  for (int world = 0; world < 6; ++world)
    for (const char* planner : {"other", "default"}) rows.push_back(row(planner, world, 1));
  EXPECT_EQ(race({"default", "other"}, both(), rows, 1)[0].planner, "default");
}

TEST(Race, HalvesTheCandidatesAndDoublesTheRepetitions) {
  std::vector<std::pair<std::size_t, int>> all;
  for (const Rung& rung : rungs(16, 20)) all.emplace_back(rung.candidates, rung.repetitions);
  EXPECT_THAT(all, ::testing::ElementsAre(std::pair(16U, 3), std::pair(8U, 5), std::pair(4U, 10),
                                          std::pair(2U, 20)));
  EXPECT_EQ(rungs(5, 1).size(), 3U);
}

TEST(Objective, IsAStatisticOrWhatOneIsOver) {
  EXPECT_EQ(objective("success").name, "goal_reached_share");
  EXPECT_EQ(objective("path_ratio").name, "path_ratio_median");
  EXPECT_EQ(objective("path_ratio_p95").name, "path_ratio_p95");
  for (const char* name : {"pathratio", "planning_time_us_mean", "map_points"}) {
    try {
      objective(name);
      ADD_FAILURE() << name;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("--for: nothing to tune for is called"));
    }
  }
}

}  // namespace
}  // namespace voronaut
