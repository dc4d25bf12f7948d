#pragma once

#include <optional>
#include <string>

#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"
#include "voronaut/benchmarks/trial/loop_config.h"
#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/environments/scenario/scenario.h"
#include "voronaut/environments/world.h"
#include "voronaut/reports/run_record.h"

namespace voronaut {

struct NavigationReport;

struct Verdict {
  Outcome outcome;
  std::string reason;
};

// Watches every vehicle step and says when a trial is over, from the true world alone.
class Referee {
 public:
  // `contacts` of the scenario's world; null: made here.
  Referee(const Scenario& scenario, const VehicleSpec& vehicle, double shortest_length_m,
          const LoopConfig& config, std::shared_ptr<const CollisionScene> contacts = nullptr);

  void judge(double now_s, const VehicleState& state);
  // What navigation says of itself. The planner's own proof that there is no path ends the trial.
  // A planner that would not take the latest problem has proved nothing: who comes to a stop for
  // that is stuck, as the world may have a path.
  void hear(double now_s, const NavigationReport& report);

  const std::optional<Verdict>& verdict() const { return verdict_; }
  // When the centre was first within the goal tolerance; empty before.
  std::optional<double> arrived_s() const { return arrived_s_; }
  double end_s() const { return end_s_; }
  bool contact_at_start() const;

 private:
  void finish(double now_s, Outcome outcome, std::string reason);
  void watch_progress(double now_s, const Vec2& p);
  std::string refusal() const;

  const Scenario& scenario_;
  LoopConfig config_;
  GroundTruthCollisionChecker contacts_;
  bool turns_;  // a polygon: which way it looks matters
  double time_limit_s_;
  std::optional<double> arrived_s_;
  std::optional<Verdict> verdict_;
  double end_s_ = 0;
  std::string refusal_;
  Vec2 anchor_;  // centre of the disc that the vehicle has not left since anchored_s_
  double anchored_s_ = 0;
};

}  // namespace voronaut
