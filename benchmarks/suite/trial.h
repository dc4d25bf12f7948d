#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "voronaut/benchmarks/episode/loop_config.h"
#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/scenario.h"
#include "voronaut/environments/sensing/range_finder.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/problem/problem.h"
#include "voronaut/reports/run_record.h"
#include "voronaut/reports/trace.h"

// One trial: everything that defines it, and what comes out of it.
namespace voronaut {

struct Tick;

struct PlannerSpec {
  std::string label;                          // unique within a suite; what reports call it
  std::string name;                           // in the catalogue
  std::map<std::string, std::string> params;  // by the planner's own names
  std::optional<NavigationConfig> navigation = std::nullopt;  // instead of the suite's
};

// flown: discover the world while flying through it. known: the whole world is given, nobody moves.
enum class TrialKind { flown, known };

struct TrialSpec {
  std::string suite;
  TrialKind kind = TrialKind::flown;
  Scenario scenario;  // instantiated: the world of this repetition
  std::string world_id;
  VehicleSpec vehicle;
  std::string regulator_name;
  RegulatorConfig regulator;
  PlannerSpec planner;
  RangeFinderConfig range_finder;
  ObstacleBaseConfig mapping;
  NavigationConfig navigation;
  LoopConfig loop;
  PlanningBudget budget;
  std::int64_t repetition = 0;
  std::uint64_t planner_seed = 1;  // > 0, derived from (suite seed, scenario, planner, repetition)
  std::string trial_id;            // SHA-256 over the canonical text of all of the above

  // Privileged references of the world, computed once per world and vehicle by the caller; NaN if
  // there is no such path.
  double shortest_length_m = kAbsent;
  double shortest_at_clearance_m = kAbsent;
};

struct TrialResult {
  RunRecord record;
  std::optional<Trace> trace;
};

// Flies one trial, or solves it if its kind is `known`, in this process: seeds OMPL, so it must be
// the first to use a random number in its process (fork before). Never throws for what a planner
// does within its contract; exceptions of a planner or std::bad_alloc pass through, the caller
// makes rows of them.
TrialResult run_trial(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_trace);

// The row of a trial that has not flown: what is known of it from its definition alone.
RunRecord record_before_flight(const TrialSpec& spec);

// The columns of the path of `ticks`, which is not empty; of one that reached the goal the ratio
// counts the rest of the way: it may end at the goal's tolerance, the reference ends at the goal.
void add_path(RunRecord& record, std::span<const Tick> ticks, const Vec2& goal_world);

// Counts what ended the solves of a trial into its row.
void add_solve_ends(RunRecord& record, const std::array<std::int64_t, kSolveEnds>& ends);

// The world as reports draw it.
TraceWorld trace_world(const Scenario& scenario, const std::string& world_id);

}  // namespace voronaut
