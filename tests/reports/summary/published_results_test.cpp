#include "voronaut/reports/summary/published_results.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace voronaut {
namespace {

using ::testing::HasSubstr;

RunRecord flown(const std::string& planner, int world, double score, double time_s) {
  RunRecord record;
  record.vehicle = "jackal";
  record.planner = planner;
  record.scenario = "barn_00" + std::to_string(world);
  record.outcome = score > 0 ? Outcome::goal_reached : Outcome::collision;
  record.barn_score = score;
  if (score > 0) record.barn_time_s = time_s;
  return record;
}

// Two worlds that all have met, and one more on each side.
std::vector<PublishedMethod> theirs() {
  return {{"slow",
           {{"barn_001", 10, 10, 0, 0.2, 30},
            {"barn_002", 10, 8, 2, 0.1, 40},
            {"barn_007", 10, 10, 0, 0.5, 10}}}};
}

std::vector<RunRecord> ours() {
  std::vector<RunRecord> records{flown("fast", 1, 0.5, 10), flown("fast", 2, 0.4, 20),
                                 flown("fast", 3, 0.5, 10), flown("bold", 1, 0, 0),
                                 flown("bold", 2, 0.3, 8),  flown("bold", 3, 0, 0)};
  records.push_back(flown("fast", 2, 0.2, 30));  // a second repetition
  RunRecord elsewhere;
  elsewhere.vehicle = "jackal";
  elsewhere.planner = "fast";
  elsewhere.scenario = "forest";
  records.push_back(elsewhere);
  return records;
}

const BarnStanding& standing(const BarnComparison& comparison, const std::string& name) {
  for (const BarnStanding& one : comparison.standings)
    if (one.name == name) return one;
  throw std::out_of_range(name);
}

TEST(PublishedResults, AreComparedOverTheWorldsThatAllHaveMet) {
  const BarnComparison comparison = beside_published(ours(), theirs());
  EXPECT_EQ(comparison.worlds, 2);
  ASSERT_EQ(comparison.standings.size(), 3U);
  EXPECT_EQ(comparison.standings[0].name, "fast") << "the best score first";
  const BarnStanding& slow = standing(comparison, "slow");
  EXPECT_EQ(slow.reached.n, 20);
  EXPECT_EQ(slow.reached.successes, 18);
  EXPECT_EQ(slow.collided.successes, 2);
  EXPECT_DOUBLE_EQ(slow.score.value, 0.15);
  EXPECT_DOUBLE_EQ(slow.time_s.value, 35);
}

TEST(PublishedResults, AverageTheRepetitionsOfAWorldBeforeTheWorlds) {
  const BarnStanding fast = standing(beside_published(ours(), theirs()), "fast");
  EXPECT_EQ(fast.reached.n, 3);
  EXPECT_DOUBLE_EQ(fast.score.value, 0.4) << "of 0.5 and the mean of 0.4 and 0.2";
  EXPECT_DOUBLE_EQ(fast.time_s.value, 17.5);
  EXPECT_EQ(fast.score.n, 2);
}

TEST(PublishedResults, CountTheTimeOfArrivalsOnly) {
  const BarnStanding bold = standing(beside_published(ours(), theirs()), "bold");
  EXPECT_DOUBLE_EQ(bold.time_s.value, 8);
  EXPECT_DOUBLE_EQ(bold.score.value, 0.15);
  EXPECT_EQ(bold.collided.successes, 1);
}

TEST(PublishedResults, AreHeldAgainstOursWorldByWorld) {
  const BarnComparison comparison = beside_published(ours(), theirs());
  ASSERT_EQ(comparison.differences.size(), 2U) << "each of ours against each of theirs";
  const BarnDifference& fast = comparison.differences[1];
  EXPECT_EQ(fast.planner, "fast");
  EXPECT_EQ(fast.method, "slow");
  EXPECT_DOUBLE_EQ(fast.score.value, 0.25) << "of 0.3 and 0.2";
  EXPECT_GE(fast.p_holm, fast.p);
  EXPECT_NEAR(comparison.differences[0].score.value, 0, 1e-12) << "of -0.2 and 0.2";
}

TEST(PublishedResults, SayNothingWhereNoWorldIsShared) {
  EXPECT_TRUE(beside_published({flown("fast", 5, 0.5, 10)}, theirs()).standings.empty());
  EXPECT_TRUE(beside_published({}, {}).standings.empty());
}

TEST(PublishedResults, AreWrittenWithWhatTheNumbersAre) {
  const std::string text = barn_text(beside_published(ours(), theirs()));
  EXPECT_THAT(text, HasSubstr("Over the 2 worlds that all have met"));
  EXPECT_THAT(text, HasSubstr("published"));
  EXPECT_THAT(barn_markdown(beside_published(ours(), theirs())), HasSubstr("| slow | published |"));
}

TEST(PublishedResults, AreJsonForPrograms) {
  const BarnComparison comparison = beside_published(ours(), theirs());
  const auto json = nlohmann::json::parse(barn_json(comparison));
  EXPECT_EQ(json["worlds"], 2);
  EXPECT_EQ(json["standings"][0]["name"], "fast");
  EXPECT_EQ(json["standings"][0]["reached"]["successes"], 3);
  EXPECT_EQ(json["differences"].size(), comparison.differences.size());
  EXPECT_DOUBLE_EQ(json["differences"][0]["p_holm"], comparison.differences[0].p_holm);
}

}  // namespace
}  // namespace voronaut
