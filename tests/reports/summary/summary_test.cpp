#include "voronaut/reports/summary/summary.h"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/summary_text.h"
#include "voronaut/reports/summary/text_table.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RunRecord trial(const std::string& planner, const std::string& scenario, int repetition,
                Outcome outcome, double path_ratio = kAbsent) {
  RunRecord r;
  r.trial_id = planner + "/" + scenario + "/" + std::to_string(repetition);
  r.planner = planner;
  r.scenario = scenario;
  r.scenario_group = scenario.substr(0, scenario.find('-'));
  r.vehicle = "quadrotor";
  r.regulator = "pd_rate";
  r.repetition = repetition;
  r.outcome = outcome;
  r.path_ratio = path_ratio;
  r.spl = outcome == Outcome::goal_reached ? 1.0 / path_ratio : 0.0;
  return r;
}

TEST(Summary, KeepsFailuresInTheDenominator) {
  const Summary s = summarise({trial("a", "paper-1", 0, Outcome::goal_reached, 1.25),
                               trial("a", "paper-1", 1, Outcome::collision),
                               trial("a", "paper-1", 2, Outcome::crash),
                               trial("a", "paper-1", 3, Outcome::invalid)});
  ASSERT_EQ(s.groups.size(), 1U);
  const PlannerSummary& a = s.groups.front();
  EXPECT_EQ(a.n, 4);
  EXPECT_EQ(a.of("goal_reached_share").successes, 1);
  EXPECT_EQ(a.of("goal_reached_share").n, 4);
  EXPECT_DOUBLE_EQ(a.of("goal_reached_share").value, 0.25);
  EXPECT_DOUBLE_EQ(a.of("spl_mean").value, 0.2);
  EXPECT_EQ(a.of("spl_mean").n, 4);
  EXPECT_EQ(a.of("path_ratio_median").n, 1);
  EXPECT_DOUBLE_EQ(a.of("path_ratio_median").value, 1.25);
  EXPECT_EQ(a.outcomes[1], 1);
  EXPECT_EQ(a.outcomes[6], 1);
  EXPECT_EQ(a.outcomes[8], 1);
  EXPECT_TRUE(s.totals.empty()) << "one group needs no pooled row";
}

TEST(PathRatio, AtClearanceIsThatOfTheBodyWhereStartAndGoalAreOnePlace) {
  RunRecord here = trial("a", "paper-1", 0, Outcome::goal_reached, 1.0);
  here.shortest_length_m = here.shortest_at_clearance_m = 0;
  const Statistic& at_clearance = statistic("path_ratio_at_clearance_mean");
  EXPECT_EQ(value_of(at_clearance, here), 1);
  here.shortest_length_m = 8;
  here.shortest_at_clearance_m = 10;
  EXPECT_DOUBLE_EQ(value_of(at_clearance, here), 0.8);
}

TEST(Summary, ATrialThatNeverStartedCountsZeroInTheSpl) {
  RunRecord never = trial("a", "paper-1", 1, Outcome::crash);
  never.spl = kAbsent;
  const Summary s = summarise({trial("a", "paper-1", 0, Outcome::goal_reached, 1.0), never});
  EXPECT_DOUBLE_EQ(s.groups.front().of("spl_mean").value, 0.5);
}

TEST(Summary, KeepsVehiclesAndRegulatorsApartAndPoolsScenarioGroups) {
  std::vector<RunRecord> records{trial("a", "paper-1", 0, Outcome::goal_reached, 1.1),
                                 trial("a", "forest-1", 0, Outcome::timeout)};
  records.push_back(records.front());
  records.back().vehicle = "cart";
  const Summary s = summarise(records);
  ASSERT_EQ(s.groups.size(), 3U);
  ASSERT_EQ(s.totals.size(), 1U);
  EXPECT_TRUE(s.totals.front().group.all_scenarios);
  EXPECT_EQ(s.totals.front().group.vehicle, "quadrotor");
  EXPECT_EQ(s.totals.front().n, 2);
}

TEST(Summary, PairsPlannersOnTheSameScenarioAndRepetition) {
  const Summary s = summarise({
      trial("a", "paper-1", 0, Outcome::goal_reached, 1.10),
      trial("b", "paper-1", 0, Outcome::goal_reached, 1.20),  // a is shorter
      trial("a", "paper-1", 1, Outcome::goal_reached, 1.100),
      trial("b", "paper-1", 1, Outcome::goal_reached, 1.105),  // within 1 %
      trial("a", "paper-1", 2, Outcome::collision),
      trial("b", "paper-1", 2, Outcome::goal_reached, 3.0),  // b arrived
      trial("a", "paper-2", 0, Outcome::collision),
      trial("b", "paper-2", 0, Outcome::timeout),            // both failed
      trial("a", "paper-2", 1, Outcome::goal_reached, 1.0),  // b has no such trial
      trial("b", "paper-2", 2, Outcome::goal_reached, 1.0),  // a has no such trial
  });
  ASSERT_EQ(s.pairings.size(), 1U);
  const PlannerPairing& p = s.pairings.front();
  EXPECT_EQ(p.planner_a, "a");
  EXPECT_EQ(p.planner_b, "b");
  EXPECT_EQ(p.n, 4);
  EXPECT_EQ(p.wins_a, 1);
  EXPECT_EQ(p.ties, 2);
  EXPECT_EQ(p.wins_b, 1);
  EXPECT_DOUBLE_EQ(p.win_share_a.value, 0.5);
  EXPECT_EQ(p.win_share_a.n, 2);
}

TEST(Summary, CallsPathsWithinOnePercentATieAndNoOthers) {
  const auto wins = [](double ratio) {
    return summarise({trial("a", "paper-1", 0, Outcome::goal_reached, 1.0),
                      trial("b", "paper-1", 0, Outcome::goal_reached, ratio)})
        .pairings.front()
        .wins_a;
  };
  EXPECT_EQ(wins(1.0099), 0);
  EXPECT_EQ(wins(1.0101), 1);
}

TEST(Summary, OrdersScenarioGroupsAsAReaderWould) {
  std::vector<RunRecord> records;
  for (const char* group :
       {"bearing 135", "bearing 45", "bearing 0", "a", "bearing 045", "bearing"}) {
    records.push_back(trial("a", group, 0, Outcome::timeout));
    records.back().scenario_group = group;
  }
  std::vector<std::string> order;
  for (const PlannerSummary& s : summarise(records).groups) {
    order.push_back(s.group.scenario_group);
  }
  EXPECT_THAT(order, ::testing::ElementsAre("a", "bearing", "bearing 0", "bearing 045",
                                            "bearing 45", "bearing 135"));
}

TEST(Summary, DoesNotDependOnTheOrderOfRecords) {
  auto run = synthetic::make_run();
  const std::string forward = summary_json(summarise(run.records));
  std::reverse(run.records.begin(), run.records.end());
  EXPECT_EQ(summary_json(summarise(run.records)), forward);
}

TEST(SummaryText, ShowsOutcomesWithTheirIntervals) {
  const std::string text = summary_text(summarise({
      trial("a", "paper-1", 0, Outcome::goal_reached, 1.25),
      trial("a", "paper-1", 1, Outcome::collision),
      trial("long name", "paper-1", 0, Outcome::goal_reached, 1.5),
  }));
  EXPECT_THAT(text, HasSubstr("paper, quadrotor with pd_rate\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "planner    n           goal reached  path ratio       path ratio    SPL  ended "
          "otherwise\n"
          "                              share      median  95th percentile   mean\n"
          "a          2     50.0 % [9.5, 90.5]       1.250            1.250  0.400  1 collision\n"
          "long name  1  100.0 % [20.7, 100.0]       1.500            1.500  0.667\n"))
      << "columns that no row has a value of are left out";
  EXPECT_THAT(text,
              HasSubstr("Over all trials: goal reached, SPL; trials that reached the goal: path "
                        "ratio. Brackets are 95 % intervals.\n"));
  EXPECT_THAT(text, HasSubstr("planner  against    n  win  tie  loss"));
}

TEST(SummaryText, AlignsNamesOfOtherScriptsAndDefusesControlCharacters) {
  const std::string text = summary_text(summarise({
      trial("Планировщик", "paper-1", 0, Outcome::goal_reached, 1.25),
      trial("\x1b[2Jevil\n", "paper-1", 0, Outcome::timeout),
  }));
  EXPECT_THAT(text, HasSubstr("?[2Jevil?    1 "));
  EXPECT_THAT(text, HasSubstr("Планировщик  1 "));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_EQ(text_width("Планировщик"), 11U);
}

TEST(SummaryText, OfNothingIsEmpty) {
  EXPECT_EQ(summary_text(summarise({})), "");
  const auto json = nlohmann::json::parse(summary_json(summarise({})));
  for (const char* list : {"groups", "pairings", "totals"}) EXPECT_TRUE(json.at(list).empty());
}

TEST(SummaryMarkdown, EscapesWhatMarkdownWouldRead) {
  const std::string text =
      summary_markdown(summarise({trial("as_published|x", "paper-1", 0, Outcome::timeout)}));
  EXPECT_THAT(text, HasSubstr("| as\\_published\\|x | 1 | 0.0 % [0.0, 79.3] |"));
  EXPECT_THAT(text, HasSubstr("|:---|---:|"));
}

TEST(SummaryJson, HoldsTheNumbersOfTheSummary) {
  const auto run = synthetic::make_run();
  const Summary s = summarise(run.records);
  const auto json = nlohmann::json::parse(summary_json(s));
  ASSERT_EQ(json["groups"].size(), s.groups.size());
  for (std::size_t i = 0; i < s.groups.size(); ++i) {
    const auto& g = json["groups"][i];
    EXPECT_EQ(g["planner"], s.groups[i].planner);
    EXPECT_EQ(g["outcomes"]["collision"], s.groups[i].outcomes[1]);
    EXPECT_EQ(g["statistics"].size(), statistics().size());
    EXPECT_EQ(g["statistics"]["goal_reached_share"]["successes"], s.groups[i].outcomes[0]);
    EXPECT_EQ(g["statistics"]["path_ratio_median"]["value"],
              s.groups[i].of("path_ratio_median").value);
  }
  EXPECT_TRUE(json["groups"][0]["statistics"]["state_checks_median"]["interval"][0].is_number());
  EXPECT_EQ(json["statistics"].size(), statistics().size());
}

TEST(SummaryCsv, HasALinePerPlannerAndFourCellsPerStatistic) {
  std::istringstream lines(summary_csv(summarise({
      trial("a", "paper-1", 0, Outcome::goal_reached, 1.25),
      trial("a", "paper-1", 1, Outcome::collision),
      trial("b, c", "paper-1", 0, Outcome::timeout),
  })));
  std::string head, a, b;
  ASSERT_TRUE(std::getline(lines, head) && std::getline(lines, a) && std::getline(lines, b));
  EXPECT_THAT(head, ::testing::StartsWith("scenario_group,vehicle,regulator,planner,n,"
                                          "goal_reached_share,goal_reached_share_low,"
                                          "goal_reached_share_high,goal_reached_share_n,"));
  EXPECT_EQ(std::count(head.begin(), head.end(), ','),
            4 + 4 * static_cast<std::ptrdiff_t>(statistics().size()));
  EXPECT_EQ(std::count(a.begin(), a.end(), ','), std::count(head.begin(), head.end(), ','));
  EXPECT_THAT(a, ::testing::StartsWith("paper,quadrotor,pd_rate,a,2,0.5,0.09"));
  EXPECT_THAT(b, ::testing::StartsWith("paper,quadrotor,pd_rate,\"b, c\",1,0,0,0.79"));
}

}  // namespace
}  // namespace voronaut
