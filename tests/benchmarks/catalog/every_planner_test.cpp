#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/tests/benchmarks/small_suite.h"

// Every planner of the catalogue flies a small forest and a small trap through the executive,
// twice: as the machine is, and with the C library's FMA and AVX2 forms masked.
namespace voronaut {
namespace {

std::string planner_lines() {
  std::string text;
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) text += "  - " + entry->name + "\n";
  return text;
}

std::string suite_text(const std::string& traces) {
  std::string text =
      "suite: every\nseed: 1\nscenarios:\n"
      "  - {name: forest, generator: {name: forest, side_m: 6, density_per_m2: 0.1}}\n"
      "  - {name: trap, generator: {name: u_trap, width_min_m: 2, width_max_m: 2.5,"
      " depth_min_m: 1, depth_max_m: 1.5}}\n"
      "vehicles: [{name: ideal, params: {max_speed_m_s: 2}}]\n"
      "navigation: {yaw_policy: path, speed_rule: stopping_distance}\n"
      "budget: {state_checks: 3000, ptc_evaluations: 6000, stop: first}\n"
      "limits: {memory_mb: 2048, cpu_s: 60, wall_s: 120}\ntraces: " +
      traces + "\nplanners:\n";
  return text + planner_lines();
}

// The whole world given; who starts at its goal has nothing to look for.
std::string suite_of_starts_at_the_goal(const std::string& kind) {
  const std::string rest =
      ", world: {circles: [[3, 0, 0.5]]}, bounds: [[-3, -3], [8, 3]], "
      "start: [0, 0], goal: ";
  return "suite: " + kind + "\nkind: " + kind + "\nscenarios:\n  - {name: same" + rest +
         "[0, 0]}\n  - {name: hair" + rest + "[0.000001, 0]}\n" +
         "vehicles: [ideal]\ntraces: none\n"
         "budget: {state_checks: 3000, ptc_evaluations: 10000, stop: first}\n"
         "limits: {memory_mb: 2048, cpu_s: 60, wall_s: 120}\nplanners:\n" +
         planner_lines();
}

using Rows = std::map<std::string, RunRecord>;  // by "scenario/planner"

void expect_same(const RunRecord& a, const RunRecord& b) {
  EXPECT_EQ(a.state_digest, b.state_digest) << a.scenario << "/" << a.planner;
  EXPECT_EQ(a.state_checks, b.state_checks) << a.scenario << "/" << a.planner;
}

class EveryPlanner : public ::testing::Test {
 protected:
  Rows fly(const std::string& results, const std::string& environment,
           const std::string& traces) const {
    return fly_suite(suite_text(traces), results, environment);
  }
  Rows fly_suite(const std::string& suite, const std::string& results,
                 const std::string& environment = "env") const {
    std::ofstream(folder_.path() / "every.yaml") << suite;
    const std::string command = "cd '" + folder_.path().string() + "' && " + environment + " '" +
                                VORONAUT_PROGRAM + "' run every.yaml --jobs 2 --out " + results +
                                " >said.txt 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    Rows rows;
    for (const RunRecord& record : OutputFolder::open(folder_.path() / results).store().records())
      rows[record.scenario + "/" + record.planner] = record;
    return rows;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(EveryPlanner, FliesAForestAndATrapAndRepeatsWhereTheCatalogueSaysSo) {
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  const Rows plain = fly("plain", "env", "none");
  const Rows again = fly("again", "env", "all");  // what is kept for a replay changes nothing
  const Rows masked = fly("masked", "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4", "none");
  ASSERT_EQ(plain.size(), 2 * catalog.entries().size());
  ASSERT_EQ(masked.size(), plain.size());
  ASSERT_EQ(again.size(), plain.size());
  int arrived = 0;
  for (const auto& [name, row] : plain) {
    EXPECT_FALSE(entry_of(row.outcome).cut_off) << name << ": " << row.reason;
    EXPECT_FALSE(entry_of(again.at(name).outcome).cut_off) << name << ": " << again.at(name).reason;
    arrived += row.outcome == Outcome::goal_reached ? 1 : 0;
    if (catalog.find(row.planner)->traits.reproducible == Reproducible::everywhere) {
      expect_same(row, masked.at(name));
      expect_same(row, again.at(name));
    }
    RecordProperty(name, std::string(to_string(row.outcome)));
  }
  EXPECT_GT(arrived, static_cast<int>(catalog.entries().size()));
}

TEST_F(EveryPlanner, HasReachedAGoalThatItStartsAt) {
  for (const std::string kind : {"known", "flown"}) {
    const Rows rows = fly_suite(suite_of_starts_at_the_goal(kind), kind);
    ASSERT_EQ(rows.size(), 2 * PlannerCatalog::built_in().entries().size());
    for (const auto& [name, row] : rows) {
      EXPECT_EQ(row.outcome, Outcome::goal_reached) << kind << " " << name << ": " << row.reason;
      if (kind == "known")
        EXPECT_EQ(row.state_checks, 0) << name << ": nothing is to be looked for";
      EXPECT_EQ(row.spl, 1) << kind << " " << name;
      EXPECT_EQ(row.path_ratio, 1) << kind << " " << name;
    }
  }
}

TEST_F(EveryPlanner, OfManyThreadsStopsAtItsFirstSolutionInAStaticTrialToo) {
  const Rows rows = fly_suite(
      "suite: first\nkind: known\ntraces: none\nscenarios:\n"
      "  - {name: wall, world: {boxes: [[3, -4, 3.2, 2]]}, bounds: [[-1, -4], [8, 4]],"
      " start: [0, 0], goal: [7, 0]}\n"
      "vehicles: [ideal]\nplanners: [CForest, AnytimePathShortening, PRMstar]\n"
      "budget: {state_checks: 100000000, ptc_evaluations: 100000000, stop: first}\n"
      "limits: {memory_mb: 4096, cpu_s: 60, wall_s: 120}\n",
      "first");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& [name, row] : rows) {
    EXPECT_EQ(row.outcome, Outcome::goal_reached) << name << ": " << row.reason;
    EXPECT_EQ(row.stops_first_solution, 1) << name;
  }
}

}  // namespace
}  // namespace voronaut
