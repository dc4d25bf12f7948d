#include "voronaut/benchmarks/known/known_trial.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

namespace voronaut {
namespace {

const std::string kSuite =
    "suite: static\nkind: known\nscenarios:\n"
    "  - {name: pillar, world: {circles: [[2.5, 2.5, 1]]}, bounds: [[-1, -1], [6, 6]],"
    " start: [0, 0], goal: [5, 5]}\n"
    "  - {name: walled, world: {segments: [[[2, -1], [2, 6]]]}, bounds: [[-1, -1], [6, 6]],"
    " start: [0, 0], goal: [5, 5]}\n"
    "vehicles: [quadrotor]\nplanners: [RRTConnect, RRTstar, VoronoiRoadmap]\n"
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

TEST(KnownTrial, SolvesWithTheWholeWorldGivenAndRepeats) {
  const auto rows = solve_all();
  ASSERT_EQ(rows.size(), 6U);
  for (const char* planner : {"RRTConnect", "RRTstar", "VoronoiRoadmap"}) {
    const RunRecord& row = rows.at(std::string("pillar/") + planner);
    EXPECT_EQ(row.outcome, Outcome::goal_reached) << row.reason;
    EXPECT_GE(row.path_ratio, 1) << planner;
    EXPECT_GE(row.clearance_min_m, 0.4) << planner;
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

TEST(KnownTrial, SaysThatNoPathWasFoundWithinTheBudget) {
  const auto rows = solve_all();
  EXPECT_EQ(rows.at("walled/RRTConnect").outcome, Outcome::timeout);
  EXPECT_EQ(rows.at("walled/RRTConnect").spl, 0);
  EXPECT_EQ(rows.at("walled/RRTConnect").stops_state_checks, 1);
  EXPECT_NE(rows.at("walled/VoronoiRoadmap").outcome, Outcome::goal_reached);
}

}  // namespace
}  // namespace voronaut
