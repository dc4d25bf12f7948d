#include "voronaut/reports/summary/paired_trials.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>
#include <malloc.h>
#include <nlohmann/json.hpp>

#include "voronaut/reports/store/store.h"
#include "voronaut/reports/summary/comparison.h"
#include "voronaut/reports/summary/comparison_text.h"
#include "voronaut/tests/reports/synthetic_run.h"
#include "voronaut/tests/support/temporary_folder.h"

// Two runs of very many trials side by side.
namespace voronaut {
namespace {

RunRecord flown(const std::string& planner, const std::string& scenario, int repetition) {
  RunRecord record = synthetic::make_record(planner + scenario + std::to_string(repetition));
  record.planner = planner;
  record.scenario = scenario;
  record.repetition = repetition;
  return record;
}

NextRecord one_by_one(std::vector<RunRecord> records) {
  return [records = std::move(records), next = std::size_t{0}]() mutable {
    return next < records.size() ? std::optional(records[next++]) : std::nullopt;
  };
}

TEST(ForEachPair, PairsWhatAgreesAndCountsWhatIsAloneOnEitherSide) {
  const std::vector<RunRecord> before{flown("a", "x", 0), flown("a", "x", 1), flown("a", "x", 1),
                                      flown("a", "y", 0), flown("c", "x", 0)};
  const std::vector<RunRecord> now{flown("a", "w", 0), flown("a", "x", 1), flown("b", "x", 0),
                                   flown("b", "x", 1), flown("c", "x", 0), flown("d", "x", 0)};
  std::string pairs;
  const Unpaired alone = for_each_pair(one_by_one(before), one_by_one(now),
                                       [&](const RunRecord& was, const RunRecord& is) {
                                         EXPECT_EQ(was.trial_id, is.trial_id);
                                         pairs += is.trial_id + " ";
                                       });
  EXPECT_EQ(pairs, "ax1 cx0 ");
  EXPECT_EQ(alone.before, 2) << "ax0 and ay0; the second ax1 is no trial of its own";
  EXPECT_EQ(alone.now, 4);
}

TEST(PairedTrials, TakeAFewBytesEach) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
  std::vector<const Statistic*> all;
  for (const Statistic& one : statistics()) all.push_back(&one);
  const auto allocated = [] {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
  };
  const double before = allocated();
  PairedTrials pairs(all);
  const RunRecord record = flown("a", "x", 0);
  for (int i = 0; i < 100'000; ++i) pairs.add(record, record);
  EXPECT_EQ(pairs.size(), 100'000);
  EXPECT_LT((allocated() - before) / 100'000, 260) << "300 MB is what a million may take";
}

TEST(PairedTrials, ResampleWorldsWhereTheyAreMany) {
  const Statistic& ratio = statistic("path_ratio_median");
  const std::vector<const Statistic*> chosen{&ratio};
  for (const int worlds : {5, 6}) {
    PairedTrials pairs(chosen);
    for (int i = 0; i < 24; ++i) {
      RunRecord record = flown("a", "x", i / 2);
      record.world_id = std::to_string(i % worlds);
      record.outcome = i < 12 ? Outcome::goal_reached : Outcome::timeout;
      record.path_ratio = 1 + i;
      pairs.add(record, record);
    }
    const PairedValues values = pairs.values_of(0);
    ASSERT_EQ(values.size(), 12U) << "of what arrived alone";
    EXPECT_EQ(values.over_worlds, worlds == 6);
    EXPECT_EQ(values.units.units, worlds == 6 ? 6U : 12U);
    EXPECT_EQ(values.units.unit_of[7], worlds == 6 ? 1U : 7U);
    EXPECT_EQ(values.now[7], 8);
    EXPECT_EQ(pairs.pairs_at_once(), 2);
  }
}

std::vector<RunRecord> another(const std::vector<RunRecord>& records) {
  std::vector<RunRecord> changed = records;
  for (std::size_t i = 0; i < changed.size(); i += 3) changed[i].outcome = Outcome::timeout;
  for (RunRecord& record : changed) record.state_checks += record.repetition;
  changed.pop_back();
  return changed;
}

TEST(StreamedComparison, DoesNotDependOnTheOrderOfRecordsAndIsThatOfTheStores) {
  const auto run = synthetic::make_run();
  std::vector<RunRecord> now = another(run.records);
  const RunComparison comparison = compare_runs(now, run.records);
  EXPECT_EQ(comparison.only_there, 1);
  EXPECT_GT(comparison.ended_differently, 0);
  const std::string expected = comparison_json(comparison);

  const TemporaryFolder folder;
  ResultStore before_store = ResultStore::create(folder.path() / "before.db");
  ResultStore now_store = ResultStore::create(folder.path() / "now.db");
  for (const RunRecord& record : run.records) before_store.keep(record, "");
  for (const RunRecord& record : now) now_store.keep(record, "");
  before_store.flush();
  now_store.flush();
  EXPECT_EQ(comparison_json(compare_runs(now_store.records_in(kPairingOrder),
                                         before_store.records_in(kPairingOrder))),
            expected);

  std::shuffle(now.begin(), now.end(), std::mt19937(1));
  EXPECT_EQ(comparison_json(compare_runs(now, run.records)), expected);
}

TEST(StreamedComparison, OfVeryManyChangesListsThoseOfTheLowestRepetitions) {
  std::vector<RunRecord> before, now;
  constexpr int kTrials = 3 * static_cast<int>(kOutcomeChangesMax) + 10;
  for (int i = 0; i < kTrials; ++i) {
    now.push_back(flown("a", "x", (7 * i) % kTrials));
    now.back().outcome = Outcome::collision;
    before.push_back(now.back());
    before.back().outcome = Outcome::timeout;
  }
  const RunComparison comparison = compare_runs(
      now, before, {.statistics = {&statistic("goal_reached_share")}, .same_flight = {}});
  EXPECT_EQ(comparison.ended_differently, kTrials);
  ASSERT_EQ(comparison.outcomes.size(), kOutcomeChangesMax);
  for (const OutcomeChange& change : comparison.outcomes) {
    EXPECT_EQ(change.outcome_before, Outcome::timeout);
    EXPECT_LT(change.now.repetition, static_cast<std::int64_t>(kOutcomeChangesMax));
  }
  EXPECT_NE(comparison_text(comparison).find(std::to_string(kTrials) + " end differently"),
            std::string::npos);
}

}  // namespace
}  // namespace voronaut
