#include "voronaut/reports/summary/comparison.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/summary/comparison_text.h"
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
    EXPECT_EQ(change.of(same, "goal_reached_share").value, 0.0);
    EXPECT_EQ(change.of(same, "path_ratio_median").value, 0.0);
    EXPECT_EQ(change.of(same, "path_ratio_median").p, 1.0);
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
  EXPECT_EQ(change.of(comparison, "goal_reached_share").value, 0.0);
  EXPECT_EQ(change.of(comparison, "path_ratio_median").n, 2);
  EXPECT_EQ(change.of(comparison, "duration_median_s").n, 2);
  EXPECT_NEAR(change.of(comparison, "path_ratio_median").value, 0.1, 1e-12);
  EXPECT_NEAR(change.of(comparison, "state_checks_median").value, 0.5, 1e-12);
  ASSERT_EQ(comparison.outcomes.size(), 2U);
  EXPECT_EQ(comparison.outcomes[0].outcome_before, collision);
  EXPECT_EQ(comparison.outcomes[0].now.outcome, goal_reached);
}

TEST(Comparison, LeavesOutOfRelativeChangesWhatWasNothingBefore) {
  using enum Outcome;
  std::vector<RunRecord> before, now;
  for (int i = 0; i < 3; ++i) {
    before.push_back(trial("a", i, goal_reached, 1));
    now.push_back(trial("a", i, goal_reached, 1));
    now.back().state_checks = 150;
  }
  before[0].state_checks = 0;
  const RunComparison comparison = compare_runs(now, before);
  const Change& checks = comparison.changes.front().of(comparison, "state_checks_median");
  EXPECT_EQ(checks.n, 2);
  EXPECT_NEAR(checks.value, 0.5, 1e-12);
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
  const RunComparison comparison = compare_runs(now, before);
  const PlannerChange& change = comparison.changes.front();
  EXPECT_GT(change.of(comparison, "path_ratio_median").interval.low, 0.0);
  EXPECT_NEAR(change.of(comparison, "path_ratio_median").value, 0.01, 1e-12);
  EXPECT_EQ(change.of(comparison, "path_ratio_median").verdict, ChangeVerdict::worse);
  EXPECT_TRUE(comparison.worse());
  EXPECT_FALSE(compare_runs(now, before, {.tolerance = 0.02}).worse());
  EXPECT_THAT(
      comparison_markdown(comparison),
      HasSubstr("| path ratio, median | 20 | +1.0 % | [+1.0, +1.0] | bootstrap over pairs |"));
}

double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11U) * 0x1p-53; }

// 40 worlds that are hard or easy, flown by planners of one skill that only luck tells apart.
std::vector<RunRecord> lucky_run(std::uint64_t seed, double share) {
  std::mt19937_64 engine(seed);
  std::vector<RunRecord> run;
  for (int i = 0; i < 40; ++i) {
    const bool arrives = uniform(engine) < share;
    run.push_back(trial("a", i, arrives ? Outcome::goal_reached : Outcome::timeout,
                        1.1 + 0.01 * i + 0.1 * uniform(engine)));
    run.back().world_id = std::to_string(i);
    run.back().duration_s = 10 + 3 * uniform(engine);
    run.back().state_checks = 100 + static_cast<std::int64_t>(engine() % 100);
  }
  return run;
}

TEST(Comparison, OfLuckAloneRarelyCallsAnythingBetterOrWorse) {
  ComparisonConfig config;
  config.bootstrap.resamples = 500;
  int called = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const RunComparison comparison =
        compare_runs(lucky_run(2 * seed, 0.7), lucky_run(2 * seed + 1, 0.7), config);
    for (const Change& change : comparison.changes.front().changes)
      if (change.verdict != ChangeVerdict::undecided) {
        ++called;
        break;
      }
  }
  EXPECT_LE(called, 10) << "5 of 100 are expected at most";
}

TEST(Comparison, SeesAPlannerThatArrivesLessOftenAndResamplesWorldsWhereTheyAreMany) {
  const RunComparison comparison = compare_runs(lucky_run(1, 0.3), lucky_run(2, 1.0));
  const PlannerChange& change = comparison.changes.front();
  EXPECT_EQ(change.of(comparison, "goal_reached_share").verdict, ChangeVerdict::worse);
  EXPECT_TRUE(change.of(comparison, "state_checks_median").over_worlds);
  EXPECT_EQ(change.of(comparison, "state_checks_median").verdict, ChangeVerdict::undecided);
  const RunComparison back = compare_runs(lucky_run(2, 1.0), lucky_run(1, 0.3));
  EXPECT_FALSE(back.worse()) << "more arrivals are not worse";
}

TEST(Comparison, FewPairsSayNothingHoweverMuchTheyDiffer) {
  using enum Outcome;
  std::vector<RunRecord> before, now;
  for (int i = 0; i < 5; ++i) {
    before.push_back(trial("a", i, goal_reached, 1.0));
    now.push_back(trial("a", i, goal_reached, 9.0));
  }
  EXPECT_FALSE(compare_runs(now, before).worse());
}

TEST(Comparison, CountsThePairsThatFlewDifferently) {
  using enum Outcome;
  const std::vector<RunRecord> before{trial("a", 0, goal_reached, 1), trial("a", 1, timeout, 0)};
  std::vector<RunRecord> now = before;
  now[1].state_checks = 7;
  ComparisonConfig config;
  config.same_flight = [](const RunRecord& a, const RunRecord& b) {
    return a.state_checks == b.state_checks;
  };
  EXPECT_EQ(compare_runs(now, before, config).changed, 1);
  EXPECT_EQ(compare_runs(before, before, config).changed, 0);
}

}  // namespace
}  // namespace voronaut
