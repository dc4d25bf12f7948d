#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "voronaut/benchmarks/trial/flight_config.h"
#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/step_response.h"
#include "voronaut/environments/scenario/scenario.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/problem/problem.h"
#include "voronaut/reports/run_record.h"
#include "voronaut/reports/trace/trace.h"

// One trial: everything that defines it, and what comes out of it.
namespace voronaut {

struct Tick;
class CollisionScene;

struct PlannerSpec {
  std::string label;                          // unique within a suite; what reports call it
  std::string name;                           // in the catalogue
  std::map<std::string, std::string> params;  // by the planner's own names
  std::optional<NavigationConfig> navigation = std::nullopt;  // instead of the suite's
};

// flown: discover the world while flying through it. static_planning: the whole world is given,
// nobody moves.
enum class TrialKind { flown, static_planning };

struct TrialSpec {
  std::string suite;
  TrialKind kind = TrialKind::flown;
  Scenario scenario;  // instantiated: the world of this repetition
  std::string world_id;
  VehicleSpec vehicle;
  std::string regulator_name;
  RegulatorConfig regulator;
  PlannerSpec planner;
  FlightConfig flight;
  std::int64_t repetition = 0;
  std::uint64_t planner_seed = 1;  // > 0, derived from (suite seed, scenario, planner, repetition)
  std::string trial_id;            // SHA-256 over the canonical text of all of the above

  // Privileged references of the world, computed once per world and vehicle by the caller; NaN if
  // there is no such path.
  double shortest_length_m = kAbsent;
  double shortest_at_clearance_m = kAbsent;

  // How hard the world is, computed once for it; NaN where nothing says so.
  double free_share = kAbsent;
  double narrowest_passage_m = kAbsent;

  // How the vehicle under its regulator answers, flown apart; NaN where nothing says so.
  StepAnswer answer{kAbsent, kAbsent, kAbsent};

  // What the world's obstacles are to the referee; where it is null the trial makes its own.
  std::shared_ptr<const CollisionScene> contacts = nullptr;
};

struct TrialResult {
  RunRecord record;
  std::optional<Trace> trace;
};

// The row of a trial that has not flown: what is known of it from its definition alone.
RunRecord record_before_flight(const TrialSpec& spec);

// Counts what ended the solves of a trial into its row.
void add_solve_ends(RunRecord& record, const std::array<std::int64_t, kSolveEnds>& ends);

}  // namespace voronaut
