#include "voronaut/reports/summary/statistics.h"

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/summary/statistic_text.h"

namespace voronaut {
namespace {

// Five trials: three arrive, one hits something, one never starts.
std::vector<RunRecord> records() {
  std::vector<RunRecord> list(5);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = static_cast<double>(i);
    RunRecord& r = list[i];
    r.barn_score = 0.5 - 0.125 * at;  // 0.5, 0.375, 0.25
    r.barn_pace = 1 - 0.25 * at;      // 1, 0.75, 0.5
    r.outcome = Outcome::goal_reached;
    r.shortest_length_m = 10;
    r.shortest_at_clearance_m = 12.5;
    r.path_ratio = 1 + 0.1 * at;  // 1, 1.1, 1.2
    r.spl = 1 - 0.25 * at;        // 1, 0.75, 0.5
    r.duration_s = 20 + 10 * at;  // 20, 30, 40
    r.clearance_smallest_m = 0.5 + 0.1 * at;
    r.speed_mean_m_s = 1 + at;  // 1, 2, 3, 4
    r.replans = static_cast<std::int64_t>(i);
    r.state_checks = 100 * static_cast<std::int64_t>(i);
    r.planning_time_us_mean = 10 * at;
    r.step_time_us_mean = 100 * at;
    r.tracking_error_rms_m = 0.1 * at;
    r.energy_j = 1000 * at;
  }
  list[3].outcome = Outcome::collision;
  list[3].barn_score = 0;
  list[3].barn_pace = kAbsent;
  list[3].path_ratio = kAbsent;
  list[3].spl = 0;
  list[3].clearance_smallest_m = 0.25;
  list[4].outcome = Outcome::infeasible;
  list[4].barn_score = 0;
  return list;
}

Trials pointers(const std::vector<RunRecord>& list) {
  Trials trials;
  for (const RunRecord& record : list) trials.push_back(&record);
  return trials;
}

TEST(Statistics, EveryOneEqualsWhatIsWorkedOutByHand) {
  struct Worked {
    double value;
    std::int64_t n;
  };
  const std::map<std::string_view, Worked> by_hand{
      {"goal_reached_share", {0.6, 5}},
      {"collision_share", {0.2, 5}},
      {"infeasible_share", {0.2, 5}},
      {"path_ratio_median", {1.1, 3}},
      {"path_ratio_mean", {1.1, 3}},
      {"path_ratio_p95", {1.19, 3}},                // 1.1 + 0.9 x 0.1
      {"path_ratio_at_clearance_mean", {0.88, 3}},  // 1.1 x 10 / 12.5
      {"spl_mean", {0.45, 5}},                      // 2.25 / 5: who never started counts 0
      {"duration_median_s", {30, 3}},
      {"clearance_smallest_m", {0.25, 4}},
      {"clearance_median_m", {0.55, 4}},  // of 0.25, 0.5, 0.6, 0.7
      {"speed_mean_median_m_s", {2.5, 4}},
      {"tracking_error_rms_median_m", {0.15, 4}},
      {"energy_median_j", {1000, 3}},
      {"replans_median", {1, 5}},  // of 0, 0, 1, 2, 3
      {"state_checks_median", {100, 5}},
      {"planning_time_us_median", {15, 4}},
      {"step_time_us_median", {150, 4}},
      {"barn_score_mean", {0.225, 5}},  // 1.125 / 5
      {"barn_pace_mean", {0.75, 3}},
  };
  const auto list = records();
  ASSERT_EQ(by_hand.size(), statistics().size());
  for (const Statistic& one : statistics()) {
    const Estimate estimate = estimate_of(one, pointers(list));
    EXPECT_NEAR(estimate.value, by_hand.at(one.name).value, 1e-12) << one.name;
    EXPECT_EQ(estimate.n, by_hand.at(one.name).n) << one.name;
  }
}

TEST(Statistics, AreToldApartByNameAndByHeadingWithinAnOutput) {
  std::set<std::string_view> names;
  for (const Statistic& one : statistics()) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_EQ(&statistic(one.name), &one);
    EXPECT_TRUE(column_of(one) != nullptr || !one.about.empty()) << one.name;
    EXPECT_TRUE(one.question.empty() || column_of(one) != nullptr) << one.name;
  }
  EXPECT_THROW(statistic("luck"), std::invalid_argument);
  for (const Output output : {kText, kEvidence, kPage, kSweep}) {
    std::set<std::string> headings;
    for (const Statistic* one : statistics_shown(output))
      EXPECT_TRUE(headings.insert(heading(*one)).second) << one->name;
  }
  std::set<std::string_view> labels;
  for (const Statistic* one : statistics_shown(kComparison))
    EXPECT_TRUE(labels.insert(one->label).second) << one->name;
}

TEST(Statistics, SayOverWhatTheyAre) {
  EXPECT_EQ(heading(statistic("duration_median_s")), "time to goal\nmedian, s");
  EXPECT_EQ(
      description_of(statistic("clearance_smallest_m")),
      "smallest over trials that moved: smallest clearance under way, centre to the surface of "
      "the true world");
  EXPECT_THAT(description_of(statistic("planning_time_us_median")),
              ::testing::EndsWith("; measured"));
}

TEST(StatisticText, WritesAShareInPercentAndANumberWithItsInterval) {
  auto list = records();
  const auto text = [&](const char* name, auto&& form) {
    const Statistic& one = statistic(name);
    return form(one, estimate_of(one, pointers(list)), outcome_counts(pointers(list)));
  };
  EXPECT_EQ(text("goal_reached_share", brief_text), "60.0 % [23.1, 88.2]");
  EXPECT_EQ(text("goal_reached_share", full_text), "3 of 5, 60.0 % [23.1, 88.2]");
  EXPECT_EQ(text("path_ratio_median", brief_text), "1.100");
  EXPECT_EQ(text("path_ratio_median", full_text), "1.100 (too few: 1.000, 1.100, 1.200)");
  EXPECT_EQ(text("clearance_smallest_m", full_text), "0.250 over 4")
      << "says it where not all of its trials have a value";
  EXPECT_EQ(other_outcomes(outcome_counts(pointers(list)), kText), "1 collision, 1 infeasible");
  EXPECT_EQ(other_outcomes(outcome_counts(pointers(list)), kEvidence), "1 infeasible");
  list.front().outcome = Outcome::timeout;
  EXPECT_EQ(other_outcomes(outcome_counts(pointers(list)), kEvidence), "1 timeout, 1 infeasible");
  EXPECT_EQ(other_outcomes(outcome_counts(pointers(list)), kEvidence, false),
            "1 budget spent, 1 infeasible")
      << "of static planning";
  list.front().outcome = Outcome::goal_reached;
  const auto once = list;
  for (int more = 0; more < 2; ++more) list.insert(list.end(), once.begin(), once.end());
  EXPECT_EQ(text("path_ratio_median", full_text), "1.100 [1.000, 1.200]");
}

TEST(StatisticText, RoundsHalvesAwayFromZeroAsThePageDoes) {
  EXPECT_EQ(fixed(0.125, 2), "0.13");
  EXPECT_EQ(fixed(-0.125, 2), "-0.13");
  EXPECT_EQ(fixed(6.25, 1), "6.3");
  EXPECT_EQ(fixed(0.0, 1), "0.0");
  EXPECT_EQ(fixed(1.005, 2), "1.00") << "is less than a half in binary";
  EXPECT_EQ(fixed(kAbsent, 2), "-");
}

}  // namespace
}  // namespace voronaut
