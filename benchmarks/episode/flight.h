#pragma once

#include <memory>

#include "voronaut/benchmarks/episode/disturbances.h"
#include "voronaut/benchmarks/episode/recorder.h"
#include "voronaut/benchmarks/episode/referee.h"
#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/dynamics/model.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/navigation/navigator.h"
#include "voronaut/planners/navigation/state_estimate.h"

namespace voronaut {

// What the navigator of a trial is told: of the world no more than its bounds.
NavigatorConfig navigator_config(const TrialSpec& spec);

// The truth that a navigator is put into, what carries out its setpoints, and who watches.
struct Flight {
  Flight(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_scans);

  VehicleState at_start() const;
  bool scan_is_due(std::size_t tick) const { return tick % ticks_per_scan == 0; }
  // What the range finder sees from there, as a scan from where the vehicle believes to be; valid
  // until the next call.
  const Scan& sense(const VehicleState& state, const VehicleState& believed, double now_s);

  const TrialSpec& spec;
  const std::size_t ticks_per_scan;
  std::unique_ptr<Model> model;
  std::unique_ptr<Regulator> regulator;
  Disturbances disturbances;
  StateEstimate estimate;
  RangeFinder range_finder;
  Random sensor_noise;
  Scan scan;
  Navigator navigator;
  Recorder recorder;
  Referee referee;
};

}  // namespace voronaut
