#include "voronaut/benchmarks/static_planning/static_trial.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/reports/store/sqlite.h"
#include "voronaut/tests/benchmarks/small_suite.h"

namespace voronaut {
namespace {

const std::string kSuite =
    "suite: static\nkind: static\nscenarios:\n"
    "  - {name: pillar, world: {circles: [[2.5, 2.5, 1]]}, bounds: [[-1, -1], [6, 6]],"
    " start: [0, 0], goal: [5, 5]}\n"
    "  - {name: walled, world: {segments: [[[2, -1], [2, 6]]]}, bounds: [[-1, -1], [6, 6]],"
    " start: [0, 0], goal: [5, 5]}\n"
    "vehicles: [{name: quadrotor, params: {planning_clearance_m: 0.4}}]\n"
    "planners: [RRTConnect, RRTstar, VoronoiRoadmap]\n"
    "budget: {state_checks: 20000, ptc_evaluations: 80000}\n";

std::map<std::string, RunRecord> solve_all() {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  const SuiteConfig suite = read_suite(ConfigNode::parse(kSuite, "static.yaml"), "", planners);
  SuiteTrials trials(suite);
  std::map<std::string, RunRecord> rows;
  ShortestReferences references = ShortestReferences::exact();
  while (auto planned = trials.next()) {
    references.add_to(planned->spec);
    rows[planned->spec.scenario.name + "/" + planned->spec.planner.label] =
        run_alone(planned->spec, suite.limits, [&](const TrialSpec& spec, bool keep_trace) {
          return run_trial(spec, planners, keep_trace);
        });
  }
  return rows;
}

TEST(StaticTrial, SolvesWithTheWholeWorldGivenAndRepeats) {
  const auto rows = solve_all();
  ASSERT_EQ(rows.size(), 6U);
  for (const char* planner : {"RRTConnect", "RRTstar", "VoronoiRoadmap"}) {
    const RunRecord& row = rows.at(std::string("pillar/") + planner);
    EXPECT_EQ(row.outcome, Outcome::goal_reached) << row.reason;
    EXPECT_GE(row.path_ratio, 1) << planner;
    EXPECT_GE(row.clearance_smallest_m, 0.4) << planner;
    EXPECT_GT(row.planning_time_us_mean, 0) << planner;
    EXPECT_EQ(row.replans, 1) << planner;
  }
  EXPECT_EQ(rows.at("pillar/RRTstar").budget_stops, 1);
  EXPECT_EQ(rows.at("pillar/RRTConnect").budget_stops, 0);
  const auto again = solve_all();
  for (const auto& [name, row] : rows) {
    EXPECT_EQ(row.state_digest, again.at(name).state_digest) << name;
    EXPECT_EQ(row.state_checks, again.at(name).state_checks) << name;
  }
}

TEST(StaticTrial, SaysThatNoPathWasFoundWithinTheBudget) {
  const auto rows = solve_all();
  EXPECT_EQ(rows.at("walled/RRTConnect").outcome, Outcome::timeout);
  EXPECT_EQ(rows.at("walled/RRTConnect").spl, 0);
  EXPECT_EQ(rows.at("walled/RRTConnect").stops_state_checks, 1);
  EXPECT_NE(rows.at("walled/VoronoiRoadmap").outcome, Outcome::goal_reached);
}

// A suite of this kind, run and exported by the program; its Planner Arena database.
class StaticSuite : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() / "static.yaml") << kSuite << "traces: all\n";
    for (const char* arguments :
         {"run static.yaml --out r --jobs 2", "export r --format plannerarena -o arena.db"}) {
      const std::string command = "cd '" + folder_.path().string() + "' && '" + VORONAUT_PROGRAM +
                                  "' " + arguments + " >said.txt 2>&1";
      ASSERT_EQ(std::system(command.c_str()), 0) << arguments;
    }
  }
  TemporaryFolder folder_;
};

TEST_F(StaticSuite, ExportsTheCostOverWorkOfAnytimePlanners) {
  const sqlite::Database arena(folder_.path() / "arena.db", sqlite::OpenMode::existing);
  sqlite::Statement rows(arena,
                         "SELECT r.id, r.path_length_m, r.state_checks, p.best_cost, "
                         "p.state_checks, p.time FROM runs r JOIN progress p ON p.runid = r.id "
                         "JOIN plannerConfigs c ON c.id = r.plannerid WHERE c.name = 'RRTstar' "
                         "ORDER BY r.id, p.time");
  int samples = 0;
  double cost_m = 1e9;
  double checks = 0;
  double path_m = 0;
  while (rows.step()) {
    EXPECT_LT(rows.real(3), cost_m);
    EXPECT_GE(rows.real(4), checks);
    EXPECT_LE(rows.real(4), rows.real(2));
    path_m = rows.real(1);
    cost_m = rows.real(3);
    checks = rows.real(4);
    ++samples;
  }
  EXPECT_GT(samples, 3);  // of the one problem that has a solution
  EXPECT_NEAR(cost_m, path_m, 2e-3);
  sqlite::Statement others(arena,
                           "SELECT count(*) FROM progress p JOIN runs r ON p.runid = r.id JOIN "
                           "plannerConfigs c ON c.id = r.plannerid WHERE c.name = 'RRTConnect'");
  ASSERT_TRUE(others.step());
  EXPECT_EQ(others.real(0), 0);  // it tells no cost
}

// Planner Arena's plots are of `time`, the boxes of a path are empty without one.
TEST_F(StaticSuite, ExportsEachSolveAsOmplsBenchmarkDoes) {
  const sqlite::Database arena(folder_.path() / "arena.db", sqlite::OpenMode::existing);
  sqlite::Statement rows(arena,
                         "SELECT solved, time, planning_time_us_mean, solution_length, "
                         "path_length_m, approximate_solution, correct_solution, "
                         "solution_clearance, clearance_mean_m, typeof(solution_length), "
                         "typeof(approximate_solution) FROM runs");
  int found = 0;
  int without_path = 0;
  while (rows.step()) {
    EXPECT_GT(rows.real(1), 0);
    EXPECT_NEAR(rows.real(1), rows.real(2) * 1e-6, 1e-12);
    if (rows.text(9) == "null") {
      EXPECT_EQ(rows.integer(0), 0);
      EXPECT_EQ(rows.text(10), "null");
      ++without_path;
      continue;
    }
    EXPECT_EQ(rows.real(3), rows.real(4));
    EXPECT_EQ(rows.real(7), rows.real(8));
    EXPECT_EQ(rows.integer(5), 1 - rows.integer(0)) << "approximate unless solved";
    EXPECT_EQ(rows.integer(6), 1);
    if (rows.integer(0) == 1) ++found;
  }
  EXPECT_EQ(found, 3);  // among the pillar
  EXPECT_GT(without_path, 0);
}

TEST_F(StaticSuite, KeepsATraceThatWalksAlongThePath) {
  const OutputFolder folder = OutputFolder::open(folder_.path() / "r");
  for (const RunRecord& record : folder.store().records()) {
    const auto trace = folder.store().trace(record.trial_id);
    ASSERT_TRUE(trace) << record.planner;
    EXPECT_TRUE(trace->static_planning);
    EXPECT_EQ(trace->searches, 1);
    EXPECT_EQ(trace->edges.empty(), trace->kept_searches == 0) << record.planner;
    EXPECT_EQ(trace->frames.front().search, trace->kept_searches - 1) << record.planner;
    if (record.outcome != Outcome::goal_reached) continue;
    EXPECT_NEAR(trace->frames.back().t_s, record.path_length_m, 2e-3) << "at 1 m/s";
    EXPECT_NEAR(trace->frames.back().x_m, record.end_x_m, 1e-3);
    for (const TraceFrame& frame : trace->frames) EXPECT_GT(frame.clearance_m, 0.39);
  }
}

}  // namespace
}  // namespace voronaut
