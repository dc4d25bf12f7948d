#include "voronaut/reports/summary/ranks.h"

#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "voronaut/reports/summary/summary_text.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

// Trials of a planner in worlds 0, 1, ...: a path ratio each, 0 for a failure.
struct Flights {
  std::string planner;
  std::vector<double> path_ratios;
};

std::vector<double> repeated(int n, double path_ratio) {
  return std::vector<double>(static_cast<std::size_t>(n), path_ratio);
}

std::vector<double> operator+(std::vector<double> a, const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Summary flown(const std::vector<Flights>& all, const std::string& group = "paper") {
  std::vector<RunRecord> records;
  for (const Flights& flights : all) {
    for (std::size_t i = 0; i < flights.path_ratios.size(); ++i) {
      RunRecord r = synthetic::make_record(flights.planner + std::to_string(i));
      r.planner = flights.planner;
      r.scenario_group = group;
      r.repetition = static_cast<std::int64_t>(i);
      const bool reached = flights.path_ratios[i] > 0;
      r.outcome = reached ? Outcome::goal_reached : Outcome::collision;
      r.path_ratio = reached ? flights.path_ratios[i] : kAbsent;
      records.push_back(r);
    }
  }
  return summarise(records);
}

std::map<std::string, std::int64_t> ranks_of(const std::vector<PlannerSummary>& planners) {
  std::map<std::string, std::int64_t> ranks;
  for (const PlannerSummary& one : planners) ranks[one.planner] = one.rank;
  return ranks;
}

using Ranks = std::map<std::string, std::int64_t>;

TEST(Rank, OfOnePlannerIsTheFirst) { EXPECT_EQ(flown({{"a", {0, 0}}}).groups.front().rank, 1); }

TEST(Rank, IsSharedWhereTheDataCannotTellAndCountsWhoIsBetterNotWhoComesBefore) {
  const auto fails = repeated(20, 0);
  const auto arrives = repeated(20, 1.2);
  // Of two that arrive alike neither is better; the third is behind both.
  EXPECT_EQ(ranks_of(flown({{"a", fails}, {"b", arrives}, {"c", arrives}}).groups),
            (Ranks{{"a", 3}, {"b", 1}, {"c", 1}}));
}

TEST(Rank, GoesByThePairsOfSuccessThatDifferAndNoOthers) {
  // 11 pairs differ, all one way: p = 2^-10. 1000 more in which both fail change nothing.
  const auto both_fail = repeated(1000, 0);
  EXPECT_EQ(
      ranks_of(
          flown({{"a", repeated(11, 0) + both_fail}, {"b", repeated(11, 1) + both_fail}}).groups),
      (Ranks{{"a", 2}, {"b", 1}}));
  // One way as often as the other.
  const auto early = repeated(11, 1) + repeated(11, 0);
  const auto late = repeated(11, 0) + repeated(11, 1);
  EXPECT_EQ(ranks_of(flown({{"a", early}, {"b", late}}).groups), (Ranks{{"a", 1}, {"b", 1}}));
}

TEST(Rank, CorrectsForAllTestsOfTheGroup) {
  // 7 pairs differ, all one way: p = 2^-6, which is 0.03 over two tests and 0.09 over six.
  const auto worse = repeated(7, 0) + repeated(1, 1);
  const auto better = repeated(8, 1);
  const auto of_two = flown({{"a", worse}, {"b", better}});
  EXPECT_EQ(ranks_of(of_two.groups), (Ranks{{"a", 2}, {"b", 1}}));
  EXPECT_DOUBLE_EQ(of_two.pairings.front().success_p_holm, 2 * 0x1p-6);
  const auto middle = repeated(4, 0) + repeated(4, 1);
  const auto of_three = flown({{"a", worse}, {"b", better}, {"c", middle}});
  EXPECT_EQ(ranks_of(of_three.groups), (Ranks{{"a", 1}, {"b", 1}, {"c", 1}}));
}

TEST(Rank, GoesByThePathWhereSuccessIsUndecided) {
  const auto longer = repeated(20, 1.3) + repeated(1, 1.0);
  const auto shorter = repeated(20, 1.2) + repeated(1, 0.0);
  const Summary summary = flown({{"a", longer}, {"b", shorter}});
  EXPECT_EQ(ranks_of(summary.groups), (Ranks{{"a", 2}, {"b", 1}}));
  EXPECT_EQ(summary.pairings.front().only_a, 1);
  EXPECT_EQ(summary.pairings.front().only_b, 0);
  EXPECT_EQ(summary.pairings.front().shorter_a(), 0);
  EXPECT_EQ(summary.pairings.front().shorter_b(), 20);
  // Within 1 % no path is the shorter one.
  EXPECT_EQ(ranks_of(flown({{"a", repeated(20, 1.205)}, {"b", repeated(20, 1.2)}}).groups),
            (Ranks{{"a", 1}, {"b", 1}}));
}

TEST(Rank, PutsSuccessBeforeThePath) {
  const auto often_short = repeated(15, 0) + repeated(45, 1.0);
  const auto always_long = repeated(60, 1.5);
  const Summary summary = flown({{"a", often_short}, {"b", always_long}});
  EXPECT_GT(summary.pairings.front().wins_a, summary.pairings.front().wins_b);
  EXPECT_EQ(ranks_of(summary.groups), (Ranks{{"a", 2}, {"b", 1}}));
}

TEST(Rank, ComparesWithinAGroupAndWithinThePooledRowsForThemselves) {
  std::vector<RunRecord> records;
  // 5 pairs of a group differ, which say nothing; 10 over both groups do. Another group comes
  // first.
  for (const std::string group : {"alone", "forest", "paper"})
    for (const char* planner : {"a", "b"})
      for (int i = 0; i < (group == "alone" ? 20 : 5); ++i) {
        RunRecord r = synthetic::make_record(planner + std::to_string(i));
        r.planner = planner;
        r.scenario = r.scenario_group = group;
        r.vehicle = group == "alone" ? "cart" : r.vehicle;
        r.repetition = i;
        r.outcome = planner == std::string("a") ? Outcome::timeout : Outcome::goal_reached;
        r.path_ratio = r.outcome == Outcome::goal_reached ? 1.1 : kAbsent;
        records.push_back(r);
      }
  const Summary summary = summarise(records);
  for (const PlannerSummary& one : summary.groups)
    EXPECT_EQ(one.rank, one.group.scenario_group == "alone" && one.planner == "a" ? 2 : 1);
  EXPECT_EQ(ranks_of(summary.totals), (Ranks{{"a", 2}, {"b", 1}}));
}

TEST(Rank, StandsInTextCsvAndJson) {
  const Summary summary = flown({{"a", repeated(20, 0)}, {"b", repeated(20, 1.1)}});
  EXPECT_NE(summary_text(summary).find("\na        20     2 "), std::string::npos)
      << summary_text(summary);
  EXPECT_NE(summary_markdown(summary).find("\n| a | 20 | 2 |"), std::string::npos);
  EXPECT_NE(summary_csv(summary).find(",a,20,2,"), std::string::npos);
  const auto json = nlohmann::json::parse(summary_json(summary));
  EXPECT_EQ(json["groups"][0]["rank"], 2);
  EXPECT_EQ(json["groups"][1]["rank"], 1);
  EXPECT_EQ(json["pairings"][0]["only_b"], 20);
  EXPECT_LT(json["pairings"][0]["success_p_holm"], 0.001);
}

}  // namespace
}  // namespace voronaut
