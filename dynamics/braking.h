#pragma once

#include <vector>

#include "voronaut/dynamics/state.h"

namespace voronaut {

// How a vehicle comes to rest: what the safety governor asks before it lets a command pass.
class BrakingModel {
 public:
  virtual ~BrakingModel() = default;

  // The track of the centre in the plane, as a polyline from here to rest: the velocity
  // `v_command` is asked for during period_s (the command in force before acts for one vehicle step
  // more), then rest. The first point is the present one. O(stopping time).
  virtual void predict(const VehicleState& state, const Eigen::Vector2d& v_command_world,
                       double period_s, std::vector<Eigen::Vector2d>& track_world) const = 0;

  // The true track stays within this of the predicted one.
  virtual double error_m() const = 0;
};

}  // namespace voronaut
