#pragma once

#include "voronaut/benchmarks/episode/body_clearance.h"
#include "voronaut/benchmarks/episode/episode_log.h"
#include "voronaut/environments/shapes/clearance_along.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/navigation/navigator.h"

namespace voronaut {

// Stands beside a flight and writes down what happens in it. Changes nothing.
class Recorder : public NavigationObserver {
 public:
  // Observes the navigator, which must outlive it, as must the world. `keep_scans`: everything that
  // a replay shows, beside what metrics are made of.
  Recorder(const World& world, const VehicleSpec& vehicle, Navigator& navigator, bool keep_scans);

  // Around each vehicle step: before anything is done in `state`, and after it has been done.
  void step_begins(double now_s, const VehicleState& state);
  void step_ends();
  // At the end, once: the state that the flight ended in, and the verdict on it.
  EpisodeLog finish(double now_s, const VehicleState& state, const Referee& referee);

  void stage_begins(Stage stage) override;
  void stage_ends(Stage stage) override;
  void path_adopted(const Path& path) override;

 private:
  void record_tick(double now_s, const VehicleState& state);
  void record_scan();
  void keep_for_replay(ScanEvent& event);
  int mode_of_scan(const NavigationReport& report);

  BodyClearance body_clearance_;
  ClearanceAlong clearance_;
  Navigator& navigator_;
  bool keep_scans_;
  bool scanned_ = false;  // in the step under way
  EpisodeLog log_;
};

}  // namespace voronaut
