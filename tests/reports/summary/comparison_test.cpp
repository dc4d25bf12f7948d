#include "voronaut/reports/summary/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/summary/summary_text.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;

RunRecord trial(const std::string& planner, int repetition, Outcome outcome, double path_ratio) {
  RunRecord record = synthetic::make_record(planner + std::to_string(repetition));
  record.planner = planner;
  record.repetition = repetition;
  record.outcome = outcome;
  record.path_ratio = outcome == Outcome::goal_reached ? path_ratio : kAbsent;
  record.duration_s = 10.0;
  record.state_checks = 100;
  return record;
}

TEST(Comparison, ARunAgainstItselfHasNotChanged) {
  const auto run = synthetic::make_run();
  const RunComparison same = compare_runs(run.records, run.records);
  EXPECT_TRUE(same.outcomes.empty());
  EXPECT_EQ(same.only_here + same.only_there, 0);
  std::int64_t pairs = 0;
  for (const PlannerChange& change : same.changes) {
    pairs += change.n;
    EXPECT_EQ(change.gained + change.lost, 0);
    EXPECT_EQ(change.of("goal_reached_share").value, 0.0);
    EXPECT_EQ(change.of("path_ratio_median").value, 0.0);
  }
  EXPECT_EQ(pairs, static_cast<std::int64_t>(run.records.size()));
}

TEST(Comparison, CountsWhatWasGainedAndLostAndMeasuresPathsOfPairsThatArrivedBothTimes) {
  using enum Outcome;
  const std::vector<RunRecord> before{trial("a", 0, goal_reached, 1.0),
                                      trial("a", 1, goal_reached, 2.0), trial("a", 2, collision, 0),
                                      trial("a", 3, goal_reached, 1.0)};
  std::vector<RunRecord> now{trial("a", 0, goal_reached, 1.1), trial("a", 1, goal_reached, 2.2),
                             trial("a", 2, goal_reached, 9.0), trial("a", 3, timeout, 0)};
  now[0].state_checks = 150;
  now[1].state_checks = 150;
  now[2].state_checks = 150;
  const RunComparison comparison = compare_runs(now, before);
  ASSERT_EQ(comparison.changes.size(), 1U);
  const PlannerChange& change = comparison.changes.front();
  EXPECT_EQ(change.n, 4);
  EXPECT_EQ(change.reached_before.successes, 3);
  EXPECT_EQ(change.reached_now.successes, 3);
  EXPECT_EQ(change.gained, 1);
  EXPECT_EQ(change.lost, 1);
  EXPECT_EQ(change.of("goal_reached_share").value, 0.0);
  EXPECT_EQ(change.of("path_ratio_median").n, 2);
  EXPECT_NEAR(change.of("path_ratio_median").value, 0.1, 1e-12);
  EXPECT_NEAR(change.of("state_checks_median").value, 0.5, 1e-12);
  ASSERT_EQ(comparison.outcomes.size(), 2U);
  EXPECT_EQ(comparison.outcomes[0].outcome_before, collision);
  EXPECT_EQ(comparison.outcomes[0].now.outcome, goal_reached);
}

TEST(Comparison, TrialsWithoutAPartnerAreCountedNotCompared) {
  using enum Outcome;
  const RunComparison comparison =
      compare_runs({trial("a", 0, goal_reached, 1), trial("new", 0, goal_reached, 1)},
                   {trial("a", 0, goal_reached, 1), trial("a", 1, goal_reached, 1),
                    trial("old", 0, goal_reached, 1)});
  EXPECT_EQ(comparison.only_here, 1);
  EXPECT_EQ(comparison.only_there, 2);
  ASSERT_EQ(comparison.changes.size(), 1U);
  EXPECT_EQ(comparison.changes.front().n, 1);
}

TEST(Comparison, AnOnePercentRegressionOfEveryTrialIsTold) {
  std::vector<RunRecord> before;
  std::vector<RunRecord> now;
  for (int i = 0; i < 20; ++i) {
    before.push_back(trial("a", i, Outcome::goal_reached, 1.0 + 0.05 * i));
    now.push_back(trial("a", i, Outcome::goal_reached, 1.01 * (1.0 + 0.05 * i)));
  }
  const PlannerChange change = compare_runs(now, before).changes.front();
  EXPECT_GT(change.of("path_ratio_median").interval.low, 0.0);
  EXPECT_NEAR(change.of("path_ratio_median").value, 0.01, 1e-12);
  EXPECT_THAT(comparison_markdown(compare_runs(now, before)),
              HasSubstr("+1.0 % [+1.0, +1.0] over 20"));
}

}  // namespace
}  // namespace voronaut
