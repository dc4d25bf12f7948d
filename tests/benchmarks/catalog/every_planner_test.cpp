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
  const PlannerCatalog catalog = PlannerCatalog::built_in();
  for (const PlannerEntry* entry : catalog.entries()) text += "  - " + entry->name + "\n";
  return text;
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
    std::ofstream(folder_.path() / "every.yaml") << suite_text(traces);
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

}  // namespace
}  // namespace voronaut
