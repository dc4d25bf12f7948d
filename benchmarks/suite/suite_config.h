#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/suite/acceptance_criterion.h"
#include "voronaut/benchmarks/suite/sweep.h"
#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/planners/catalog/catalog.h"

// A suite: scenarios x vehicles x planners x repetitions, and the rules that all of them share.
namespace voronaut {

enum class Repeat { all, random };                // random: a scenario with one world is flown once
enum class TraceKeeping { all, failures, none };  // failures: whatever did not reach the goal

struct TrialLimits {
  ProcessLimits process;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("memory_mb", process.memory_mb, 16, 1e6, "Address space that a trial may add");
    v.number("cpu_s", process.cpu_s, 1, 1e6, "CPU time of a trial");
    v.number("wall_s", process.wall_s, 0.1, 1e6, "Wall time of a trial");
  }
};

// A vehicle as a suite flies it; vehicle.name is its label.
struct VehicleEntry {
  VehicleSpec vehicle;
  std::string regulator_name;
  RegulatorConfig regulator;
  bool footprint_of_scenario = false;  // each scenario tells it; see footprint_entry.h
  std::optional<FlightConfig> flight = std::nullopt;  // instead of the suite's
  // Of planners that have their own, by label, over that flight.
  std::map<std::string, NavigationConfig> navigation = {};
};

struct SuiteConfig {
  std::string name;
  TrialKind kind = TrialKind::flown;
  std::uint64_t seed = 1;
  int repetitions = 1;
  Repeat repeat = Repeat::all;
  std::string data;
  std::vector<ScenarioSpec> scenarios;  // names unique
  std::vector<VehicleEntry> vehicles;   // labels unique
  std::vector<PlannerSpec> planners;    // labels unique
  std::vector<SweepAxis> sweep;         // what made many entries of one; they are in the lists
  FlightConfig flight;
  TrialLimits limits;
  TraceKeeping traces = TraceKeeping::all;
  std::vector<AcceptanceCriterion> acceptance;

  template <class Visitor>
  void visit(Visitor& v) {
    v.form("include", "[file, ...]",
           "Suite files beside this one, whose keys hold where it has none");
    v.text("suite", name, "Its name: letters, digits, '-', '_' and '.'; becomes a folder");
    v.choice("kind", kind, {{"flown", TrialKind::flown}, {"static", TrialKind::static_planning}},
             "Discover the world while flying through it, or plan once with all of it given");
    v.count("seed", seed, 0, std::numeric_limits<std::int64_t>::max(),
            "What the seeds of worlds and planners are derived from");
    v.count("repetitions", repetitions, 1, 1'000'000, "Of each scenario, vehicle and planner");
    v.choice("repeat", repeat, {{"all", Repeat::all}, {"random", Repeat::random}},
             "random: a scenario with one world is flown once");
    v.text("data", data,
           "Folder of foreign data sets, beside this file; --data and VORONAUT_DATA win");
    v.form("scenarios", "[scenario, ...]", "What is flown");
    v.form("vehicles", "[vehicle, ...]", "What flies");
    v.form("planners", "[planner, ...]", "Who plans");
    v.form("sweep", "section", "Values by path that all of them fly at (sweeps.md)");
    flight.visit(v);
    v.section("limits", limits, "What the process of a trial may take");
    v.choice("traces", traces,
             {{"all", TraceKeeping::all},
              {"failures", TraceKeeping::failures},
              {"none", TraceKeeping::none}},
             "Which flights are kept for the replay; failures: whatever did not reach the goal");
    v.form("acceptance", "[criterion, ...]", "What the results must show");
  }
};

// Reads the root of a suite file, all keys of which stand in docs/keys.md:
//
//   suite: quadrotor-paper
//   scenarios: [...]                 entries of read_scenarios()
//   vehicles: [quadrotor, {name: quadrotor, label: slow, params: {max_speed_m_s: 1},
//              model: {...}, regulator: pd_rate | {name: pd_rate, params: {...}}}]
//   planners: [RRTConnect, {name: RRTConnect, label: greedy, params: {range: 0.5},
//              navigation: {...}}]   its own instead of the suite's, key by key; so may a
//                                    vehicle have all sections of FlightConfig
//   sweep: {vehicle.max_speed_m_s: [1, 2]}   see sweep.h
//   acceptance: [{planner: RRTConnect, goal_reached_share_min: 1}]   see acceptance_criterion.h
//   and the other keys of SuiteConfig
//
// and everything it names. A cart drives at height 0 whatever the scenario's heights. Each planner
// is made once, in a process of its own, and given its parameters, each vehicle and regulator is
// built, so that what is wrong is found here. Throws ConfigError.
SuiteConfig read_suite(const ConfigNode& root, const std::string& data_argument,
                       const PlannerCatalog& planners);

// One entry of `vehicles` and of `planners`; `flight` and `navigation` are the suite's.
VehicleEntry read_vehicle(const ConfigNode& entry, const FlightConfig& flight);
PlannerSpec read_planner(const ConfigNode& entry, const PlannerCatalog& planners,
                         const NavigationConfig& navigation);
// One entry of `acceptance`; what it is about must be in the suite.
AcceptanceCriterion read_criterion(const ConfigNode& entry, const SuiteConfig& suite);

// How a planner's trials on a vehicle are flown: the planner's own navigation wins over what the
// vehicle has of its own, that over the suite's.
FlightConfig flight_of(const SuiteConfig& suite, const VehicleEntry& vehicle,
                       const PlannerSpec& planner);

// Keeps only the planners with these labels, or all that a sweep made of one; throws
// std::invalid_argument for one that is not there.
void keep_planners(SuiteConfig& suite, const std::vector<std::string>& labels);

}  // namespace voronaut
