#include "voronaut/reports/summary/summary_table.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <malloc.h>

#include "voronaut/reports/page/html_report.h"
#include "voronaut/reports/page/report_data.h"
#include "voronaut/reports/store/csv_writer.h"
#include "voronaut/tests/reports/synthetic_run.h"
#include "voronaut/tests/support/temporary_folder.h"

// Runs of very many trials: what a summary and a report of them need.
namespace voronaut {
namespace {

double allocated_mb() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1024 * 1024);
}

TEST(SummaryTable, HoldsNoRecords) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer has an allocator of its own";
#endif
  const auto run = synthetic::make_run({.repetitions = 20, .traced_repetitions = 0});
  const double before_mb = allocated_mb();
  SummaryTable table;
  for (int round = 0; round < 200; ++round)
    for (const RunRecord& record : run.records) table.add(record);
  const double each_bytes =
      (allocated_mb() - before_mb) * 1024 * 1024 / static_cast<double>(table.size());
  EXPECT_EQ(table.size(), 200 * static_cast<std::int64_t>(run.records.size()));
  EXPECT_LT(each_bytes, 200) << "300 MB is what a million may take";
}

TEST(SummaryTable, PairsWhatWasFlownInTheSameScenarioAndRepetition) {
  SummaryTable table;
  RunRecord record = synthetic::make_record("t");
  const auto add = [&](const char* planner, const char* scenario, int repetition, double ratio) {
    record.planner = planner;
    record.scenario = scenario;
    record.repetition = repetition;
    record.path_ratio = ratio;
    table.add(record);
  };
  add("a", "one", 0, 1.0);
  add("a", "two", 0, 1.5);
  add("a", "two", 1, 1.0);
  add("b", "two", 0, 1.0);
  add("b", "one", 0, 1.5);
  add("b", "three", 1, 1.0);
  const Summary summary = table.summarise();
  ASSERT_EQ(summary.pairings.size(), 1U);
  EXPECT_EQ(summary.pairings[0].n, 2);
  EXPECT_EQ(summary.pairings[0].wins_a, 1);
  EXPECT_EQ(summary.pairings[0].wins_b, 1);
}

// Values of which the resampled interval is known well: both forms on either side of the switch.
TEST(Limit, IsWhatResamplingTendsTo) {
  std::vector<double> values;
  for (std::size_t i = 0; i < kResampledMax; ++i)
    values.push_back(std::fmod(0.618033988749895 * static_cast<double>(i + 1), 1.0));
  const Estimate mean = mean_estimate(values);
  const Estimate median = quantile_estimate(values, 0.5);
  const Estimate tail = quantile_estimate(values, 0.95);
  values.push_back(0.5);
  const auto expect_near = [](const Estimate& limit, const Estimate& resampled) {
    const double width = resampled.interval.high - resampled.interval.low;
    EXPECT_NEAR(limit.value, resampled.value, 0.02 * width);
    EXPECT_NEAR(limit.interval.low, resampled.interval.low, 0.1 * width);
    EXPECT_NEAR(limit.interval.high, resampled.interval.high, 0.1 * width);
  };
  expect_near(mean_estimate(values), mean);
  expect_near(quantile_estimate(values, 0.5), median);
  expect_near(quantile_estimate(values, 0.95), tail);
}

TEST(BigReport, IsOverAllTrialsAndDrawsThoseOfTheLowestRepetitions) {
  const TemporaryFolder folder;
  const auto run = synthetic::make_run({.repetitions = 50, .traced_repetitions = 0});
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  for (const RunRecord& record : run.records) store.keep(record, "");
  store.flush();
  const ReportInput input = read_report_input(store, "big", "", 1 << 20, 60);
  EXPECT_EQ(input.stored_trials, run.records.size());
  ASSERT_EQ(input.records.size(), 60U);
  for (const RunRecord& record : input.records) EXPECT_LT(record.repetition, 5);
  std::int64_t summarised = 0;
  for (const PlannerSummary& planner : input.summary.groups) summarised += planner.n;
  EXPECT_EQ(summarised, static_cast<std::int64_t>(run.records.size()));
  EXPECT_NE(report_data_json(input).find("\"stored_trials\":600"), std::string::npos);
}

TEST(Csv, OfAStoreIsThatOfItsRecords) {
  const TemporaryFolder folder;
  const auto run = synthetic::make_run({.traced_repetitions = 0});
  ResultStore store = ResultStore::create(folder.path() / "results.db");
  for (const RunRecord& record : run.records) store.keep(record, "");
  store.flush();
  std::ostringstream text;
  write_csv_of(store, text);
  EXPECT_EQ(text.str(), records_to_csv(store.records()));
}

}  // namespace
}  // namespace voronaut
