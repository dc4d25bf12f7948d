#pragma once

#include <functional>
#include <vector>

#include "voronaut/dynamics/model.h"
#include "voronaut/dynamics/regulator.h"

namespace voronaut::testing {

inline constexpr double kPeriod_s = 0.01;

using Guide = std::function<Setpoint(double time_s, const VehicleState& state)>;

// States at 0, T, 2T ... of a vehicle under a regulator whose command is applied one step later, as
// the benchmark's loop does it.
inline std::vector<VehicleState> fly(const Model& model, Regulator& regulator,
                                     const VehicleState& start, double duration_s,
                                     const Guide& guide) {
  std::vector<VehicleState> states{start};
  regulator.reset(start);
  Command pending = model.hold();
  const int steps = static_cast<int>(duration_s / kPeriod_s + 0.5);
  for (int i = 0; i < steps; ++i) {
    const VehicleState state = states.back();
    const Command next = regulator.regulate(guide(i * kPeriod_s, state), state);
    states.push_back(model.step(state, pending, kPeriod_s));
    pending = next;
  }
  return states;
}

// Free steps under one command.
inline VehicleState coast(const Model& model, VehicleState state, const Command& command,
                          double duration_s, double period_s = kPeriod_s) {
  const int steps = static_cast<int>(duration_s / period_s + 0.5);
  for (int i = 0; i < steps; ++i) state = model.step(state, command, period_s);
  return state;
}

// Cosine of the angle between the body's z axis and the vertical.
inline double cos_tilt(const VehicleState& state) {
  const Eigen::Quaterniond& q = state.q_world_body;
  return 1 - 2 * (q.x() * q.x() + q.y() * q.y());
}

}  // namespace voronaut::testing
