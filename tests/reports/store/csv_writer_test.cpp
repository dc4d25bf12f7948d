#include "voronaut/reports/store/csv_writer.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/reports/record_columns.h"
#include "voronaut/tests/reports/synthetic_run.h"

namespace voronaut {
namespace {

TEST(CsvField, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_field("plain name"), "plain name");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"hi\""), "\"say \"\"hi\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, KeepsSpreadsheetsFromRunningIt) {
  EXPECT_EQ(csv_field("=1+2"), "'=1+2");
  EXPECT_EQ(csv_field("+a"), "'+a");
  EXPECT_EQ(csv_field("-a"), "'-a");
  EXPECT_EQ(csv_field("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_field("\t=1"), "'\t=1");
  EXPECT_EQ(csv_field("=\"x\",1"), "\"'=\"\"x\"\",1\"");
  EXPECT_EQ(csv_field("'quoted"), "''quoted") << "taking one off gives the text back";
  EXPECT_EQ(csv_field("a=1"), "a=1");
}

TEST(Csv, GuardsLabelsAndLeavesNegativeNumbersAlone) {
  RunRecord record = synthetic::make_record("t1");
  record.planner = "=HYPERLINK(\"x\")";
  record.end_x_m = -1.5;
  const std::string csv = records_to_csv({record});
  EXPECT_THAT(csv, ::testing::HasSubstr(",\"'=HYPERLINK(\"\"x\"\")\","));
  EXPECT_THAT(csv, ::testing::HasSubstr(",-1.5,"));
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(cell_text(0.1), "0.1");
  EXPECT_EQ(cell_text(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(cell_text(3.0), "3");
  EXPECT_EQ(cell_text(-2.5e-9), "-2.5e-09");
  EXPECT_EQ(cell_text(kAbsent), "");
  EXPECT_EQ(cell_text(-0.0), "0");
}

TEST(Csv, MatchesTheGoldenFile) {
  // Measured columns differ from run to run: here they are absent, so the golden text has none.
  RunRecord record = synthetic::make_record("t1");
  record.planner = "RRT, \"fast\"";
  record.planning_time_us_mean = kAbsent;
  EXPECT_EQ(
      records_to_csv({record}),
      "trial_id,suite,scenario,scenario_group,world_id,vehicle,regulator,planner,repetition,seed,"
      "outcome,reason,duration_s,path_length_m,shortest_length_m,shortest_at_clearance_m,"
      "free_share,narrowest_passage_m,path_ratio,spl,clearance_smallest_m,clearance_mean_m,body_"
      "clearance_smallest_m,speed_"
      "mean_m_s,speed_max_m_s,end_x_m,"
      "end_y_m,barn_time_s,barn_score,barn_pace,replans,state_checks,budget_stops,stops_state_"
      "checks,stops_ptc_evaluations,"
      "stops_iterations,stops_wall_clock,stops_first_solution,map_points,map_obstacles,modes,"
      "state_digest,tracking_error_rms_m,tracking_error_max_m,energy_j,settling_s,overshoot_m,"
      "stopping_"
      "distance_m,"
      "mapping_time_us_mean,mapping_time_us_p99,planning_time_us_mean,planning_time_us_p99,"
      "step_time_us_mean,step_time_us_p99,cpu_time_s,memory_max_mb\r\n"
      "t1,synthetic,between,paper,w0,quadrotor,pd_rate,\"RRT, \"\"fast\"\"\",2,"
      "-9000000000000000001,goal_reached,at rest 0.1 m from the goal,0.30000000000000004,15.25,"
      "14.2,,,,1.073943661971831,0.9311475409836065,0.51,,,,,,,,,,17,0,0,0,0,0,0,0,0,0,none "
      "left,,,,,,,,,,,,,,,\r\n");
}

TEST(Csv, HasOneLinePerRecordInTheGivenOrder) {
  const auto run = synthetic::make_run();
  std::istringstream lines(records_to_csv(run.records));
  std::string line;
  std::getline(lines, line);
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    EXPECT_THAT(line, ::testing::StartsWith(run.records.at(count).trial_id + ","));
    EXPECT_EQ(line.back(), '\r');
    ++count;
  }
  EXPECT_EQ(count, run.records.size());
}

}  // namespace
}  // namespace voronaut
