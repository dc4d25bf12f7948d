#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"

namespace voronaut::testing {

inline constexpr double kPeriod_s = 0.01;

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr double kFar_m = 1e6;

inline QuadrotorConfig quadrotor_with(QuadrotorConfig::InertiaSet inertia) {
  QuadrotorConfig config;
  config.inertia = inertia;
  return config;
}

// Only the tilt limits the acceleration.
inline MotionLimits tilt_limited(double max_tilt_deg) {
  return {.max_speed_m_s = 5, .max_acceleration_m_s2 = 100, .max_tilt_rad = max_tilt_deg * kDegree};
}

// Through a point, and to rest at one.
inline Setpoint pass(const Vec3& p, double speed_m_s,
                     const Eigen::Vector2d& heading = Eigen::Vector2d::UnitX()) {
  return {PassTarget{p.head<2>(), speed_m_s}, p.z(), heading};
}
inline Setpoint rest(const Vec3& p, double speed_m_s,
                     const Eigen::Vector2d& heading = Eigen::Vector2d::UnitX()) {
  return {RestAtTarget{p.head<2>(), speed_m_s}, p.z(), heading};
}

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

inline double tilt_deg(const VehicleState& s) { return std::acos(cos_tilt(s)) / kDegree; }

// Time at which the vehicle lies on its side, or -1.
inline double flip_time_s(const std::vector<VehicleState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (cos_tilt(states[i]) <= 0) return static_cast<double>(i) * kPeriod_s;
  }
  return -1;
}

}  // namespace voronaut::testing
