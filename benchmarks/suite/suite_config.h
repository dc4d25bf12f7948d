#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/benchmarks/episode/loop_config.h"
#include "voronaut/benchmarks/runner/child_process.h"
#include "voronaut/benchmarks/suite/claim.h"
#include "voronaut/benchmarks/suite/trial.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/planners/catalog/catalog.h"

// A suite: scenarios x vehicles x planners x repetitions, and the rules that all of them share.
namespace voronaut {

enum class Repeat { all, random };                // random: a scenario with one world is flown once
enum class TraceKeeping { all, failures, none };  // failures: whatever did not reach the goal

struct TrialLimits {
  ProcessLimits process;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("memory_mb", process.memory_mb, 16, 1e6);
    v.number("cpu_s", process.cpu_s, 1, 1e6);
    v.number("wall_s", process.wall_s, 0.1, 1e6);
  }
};

// A vehicle as a suite flies it; vehicle.name is its label.
struct VehicleEntry {
  VehicleSpec vehicle;
  std::string regulator_name;
  RegulatorConfig regulator;
};

struct SuiteConfig {
  std::string name;
  TrialKind kind = TrialKind::flown;
  std::uint64_t seed = 1;
  int repetitions = 1;
  Repeat repeat = Repeat::all;
  std::vector<ScenarioSpec> scenarios;  // names unique
  std::vector<VehicleEntry> vehicles;   // labels unique
  std::vector<PlannerSpec> planners;    // labels unique
  RangeFinderConfig range_finder;
  ObstacleBaseConfig mapping;
  NavigationConfig navigation;
  LoopConfig loop;
  PlanningBudget budget;
  TrialLimits limits;
  TraceKeeping traces = TraceKeeping::all;
  std::vector<Claim> claims;
};

// Reads the root of a suite file:
//
//   suite: quadrotor-paper           name, required
//   seed: 1
//   repetitions: 1
//   repeat: all | random             random: a scenario with one world is flown once
//   data: folder                     beside this file; --data and VORONAUT_DATA win
//   scenarios: [...]                 entries of read_scenarios()
//   vehicles: [quadrotor, {name: quadrotor, label: slow, params: {max_speed_m_s: 1},
//              model: {...}, regulator: pd_rate | {name: pd_rate, params: {...}}}]
//   planners: [RRTConnect, {name: RRTConnect, label: greedy, params: {range: 0.5},
//              navigation: {...}}]   its own instead of the suite's, key by key
//   range_finder, mapping, navigation, loop: {...}   keys of their Config
//   budget: {state_checks: 50000, ptc_evaluations: 200000}   see budget_config.h
//   limits: {memory_mb: 1024, cpu_s: 120, wall_s: 300}
//   traces: all | failures | none
//   kind: flown | known             known: static planning with the whole world given
//   claims: [{planner: RRTConnect, outcome_share_min: 1}]   keys of Claim
//
// and everything it names. A cart drives at height 0 whatever the scenario's heights; its suites
// say `navigation: {yaw_policy: path}` and no governor. Each planner is made once, in a process of
// its own, and given its parameters, each vehicle and regulator is built, so that what is wrong is
// found here. Throws ConfigError.
SuiteConfig read_suite(const ConfigNode& root, const std::string& data_argument,
                       const PlannerCatalog& planners);

// One entry of `vehicles` and of `planners`; `navigation` is the suite's.
VehicleEntry read_vehicle(const ConfigNode& entry);
PlannerSpec read_planner(const ConfigNode& entry, const PlannerCatalog& planners,
                         const NavigationConfig& navigation);
// One entry of `claims`; what it is about must be in the suite.
Claim read_claim(const ConfigNode& entry, const SuiteConfig& suite);

// Keeps only the planners with these labels; throws std::invalid_argument for one that is not
// there.
void keep_planners(SuiteConfig& suite, const std::vector<std::string>& labels);

}  // namespace voronaut
