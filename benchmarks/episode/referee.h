#pragma once

#include <memory>
#include <optional>
#include <string>

#include "voronaut/benchmarks/trial/loop_config.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/environments/scenario/scenario.h"
#include "voronaut/environments/world.h"
#include "voronaut/reports/run_record.h"

namespace voronaut {

// Contacts of an upright cylinder with the true world, answered by FCL: an opinion that shares no
// code with our planners, sensors and clearances. Circles are cylinders, walls and the outlines of
// polygons are upright rectangles; a body that starts inside a polygon is the scenario's error.
// Within 1e-5 m of a surface FCL's iterative answer may fall either way.
class ContactOracle {
 public:
  ContactOracle(const Shapes& shapes, double body_radius_m);
  ~ContactOracle();

  // True if the body centred at p touches anything. O(log n) broad phase plus the overlapping
  // pairs.
  bool touches(const Vec2& p_world) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

struct Verdict {
  Outcome outcome;
  std::string reason;
};

// Watches every vehicle step and says when a trial is over, from the true world alone.
class Referee {
 public:
  Referee(const Scenario& scenario, double body_radius_m, double shortest_length_m,
          const LoopConfig& config);

  void judge(double now_s, const VehicleState& state);
  // The planner's own proof that there is no path ends the trial.
  void accept_infeasible(double now_s, const std::string& reason);
  // Why the planner would not take the latest problem, empty if it did: who comes to a stop for
  // that is stuck, as the world may have a path.
  void note_refusal(const std::string& why) { refusal_ = why; }

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
  ContactOracle contacts_;
  double time_limit_s_;
  std::optional<double> arrived_s_;
  std::optional<Verdict> verdict_;
  double end_s_ = 0;
  std::string refusal_;
  Vec2 anchor_;  // centre of the disc that the vehicle has not left since anchored_s_
  double anchored_s_ = 0;
};

}  // namespace voronaut
