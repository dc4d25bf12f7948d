#pragma once

#include <vector>

#include "voronaut/dynamics/braking.h"
#include "voronaut/planners/mapping/free_space.h"

namespace voronaut {

struct SafetyGovernorConfig {
  double period_s = 0.05;       // between two decisions
  double body_radius_m = 0.25;  // R
  double range_error_m = 0.0;   // of a beam: folded into the body

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("period_s", period_s, 0.001, 1);
    v.number("body_radius_m", body_radius_m, 0.01, 10);
    v.number("range_error_m", range_error_m, 0, 1);
  }
};

// Lets a velocity command pass only as fast as the vehicle can still stop in space known to be
// free.
//
// A command is accepted if the disc of the body, swept along [one period under the command, then
// full braking to rest], touches only cells that beams proved empty. Invariant: at every decision
// the braking track from the present state is such; a command is accepted only if it still holds a
// period later, else the vehicle brakes, which keeps it. So no collision, provided that
//   1. the world does not move,
//   2. poses are exact and ranges err by at most range_error_m,
//   3. the vehicle brakes within error_m() of its braking model,
//   4. the body stands in known-free space when it sets off,
//   5. no obstacle hides between two beams at the distance at which a cell is called free.
// No rule on speed is needed beside it.
class SafetyGovernor {
 public:
  SafetyGovernor(const SafetyGovernorConfig& config, const BrakingModel& braking)
      : config_(config), braking_(braking) {}

  struct Decision {
    double speed_m_s = 0;  // allowed along the wanted direction; 0: brake
    bool braking = false;  // nothing passed: full braking
  };

  // The largest of a few shares of wanted_speed_m_s that is safe in the unit direction `towards`.
  // O(shares x (stopping time + rows of the tube)); nearly always the first share passes.
  Decision decide(const VehicleState& state, const FreeSpace& known_free,
                  const Eigen::Vector2d& towards, double wanted_speed_m_s);

  // The track behind the latest decision, for drawings.
  const std::vector<Eigen::Vector2d>& track_world() const { return track_; }

 private:
  bool track_is_free(const FreeSpace& known_free) const;

  SafetyGovernorConfig config_;
  const BrakingModel& braking_;
  std::vector<Eigen::Vector2d> track_;
};

}  // namespace voronaut
