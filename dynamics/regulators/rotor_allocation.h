#pragma once

#include "voronaut/dynamics/models/quadrotor.h"

namespace voronaut {

// What a regulator asks of the body: thrust along its z axis, torque about its axes.
struct Wrench {
  double thrust_N = 0;
  Vec3 torque_N_m = Vec3::Zero();
};

// The rotor speeds that give a wrench: eq. (2) of the quadrotor planner paper solved for the
// squares of the speeds. What the rotors cannot give is taken from yaw first, then from tilt, then
// from thrust: thrust is clipped so that a share of the range is left for torque, the torque that
// tilts keeps its direction, yaw has the rest and never more than a share.
class RotorAllocation {
 public:
  explicit RotorAllocation(const QuadrotorConfig& vehicle);

  // O(1). Within the vehicle's limits for any finite wrench up to 1e100.
  Command speeds(const Wrench& wrench) const;

  // Largest torque about a horizontal axis at the thrust that hovers.
  double max_tilt_torque_N_m() const;

 private:
  double square_per_thrust_, square_per_tilt_torque_, square_per_yaw_torque_;
  double min_square_, max_square_, hover_square_;  // of a rotor's speed [rad^2/s^2]
};

}  // namespace voronaut
