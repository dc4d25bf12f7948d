#include "voronaut/dynamics/models/quadrotor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <sleef.h>

#include "voronaut/dynamics/attitude.h"
#include "voronaut/dynamics/integrate.h"

namespace voronaut {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;
using RotorSpeeds = std::array<double, 4>;

// p, v, q (w x y z), body rates; with motor lag the rotor speeds follow.
constexpr std::size_t kBodySize = 13;
using BodyState = std::array<double, kBodySize>;
using LaggedState = std::array<double, kBodySize + 4>;

// Accelerations that the rotors give to the body, and their gyroscopic coefficients.
struct RotorEffect {
  double twice_thrust_m_s2, thrust_less_weight_m_s2;
  double roll_rad_s2, pitch_rad_s2, yaw_rad_s2;
  double gyro_p_1_s, gyro_q_1_s;  // J_TP Omega / I_xx, / I_yy
};

// Eq. (2) divided by mass and inertia.
RotorEffect rotor_effect(const RigidBodyCoefficients& c, const double* w) {
  const double s1 = w[0] * w[0], s2 = w[1] * w[1], s3 = w[2] * w[2], s4 = w[3] * w[3];
  const double omega = w[0] - w[1] + w[2] - w[3];
  const double thrust = c.thrust * (s1 + s2 + s3 + s4);
  return {.twice_thrust_m_s2 = 2 * thrust,
          .thrust_less_weight_m_s2 = thrust - c.gravity_m_s2,
          .roll_rad_s2 = c.roll * (s4 - s2),
          .pitch_rad_s2 = c.pitch * (s3 - s1),
          .yaw_rad_s2 = c.yaw * (s2 + s4 - s1 - s3),
          .gyro_p_1_s = c.gyro_p * omega,
          .gyro_q_1_s = c.gyro_q * omega};
}

// Eq. (1) with the exact quaternion kinematics q' = q (0, w) / 2.
inline void body_derivative(const double* x, const RigidBodyCoefficients& body,
                            const RotorEffect& rotors, double* dx) {
  const double qw = x[6], qx = x[7], qy = x[8], qz = x[9];
  const double p = x[10], q = x[11], r = x[12];
  dx[0] = x[3];
  dx[1] = x[4];
  dx[2] = x[5];
  dx[3] = rotors.twice_thrust_m_s2 * (qx * qz + qw * qy);
  dx[4] = rotors.twice_thrust_m_s2 * (qy * qz - qw * qx);
  dx[5] = rotors.thrust_less_weight_m_s2 - rotors.twice_thrust_m_s2 * (qx * qx + qy * qy);
  if (body.drag_1_s > 0) {
    for (std::size_t i = 3; i < 6; ++i) dx[i] -= body.drag_1_s * x[i];
  }
  const double hp = 0.5 * p, hq = 0.5 * q, hr = 0.5 * r;
  dx[6] = -(qx * hp + qy * hq + qz * hr);
  dx[7] = qw * hp + qy * hr - qz * hq;
  dx[8] = qw * hq + qz * hp - qx * hr;
  dx[9] = qw * hr + qx * hq - qy * hp;
  dx[10] = (body.coupling_p * r - rotors.gyro_p_1_s) * q + rotors.roll_rad_s2;
  dx[11] = (body.coupling_q * r + rotors.gyro_q_1_s) * p + rotors.pitch_rad_s2;
  dx[12] = body.coupling_r * p * q + rotors.yaw_rad_s2;
}

RigidBodyCoefficients coefficients_of(const QuadrotorConfig& c) {
  const Vec3 inertia = c.inertia_kg_m2();
  const double moment = c.thrust_factor_N_s2 * c.arm_m;
  return {.gravity_m_s2 = c.gravity_m_s2,
          .drag_1_s = c.linear_drag_1_s,
          .thrust = c.thrust_factor_N_s2 / c.mass_kg,
          .roll = moment / inertia.x(),
          .pitch = moment / inertia.y(),
          .yaw = c.drag_factor_N_m_s2 / inertia.z(),
          .gyro_p = c.rotor_inertia_kg_m2 / inertia.x(),
          .gyro_q = c.rotor_inertia_kg_m2 / inertia.y(),
          .reaction = c.rotor_acceleration_torque ? c.rotor_inertia_kg_m2 / inertia.z() : 0,
          .coupling_p = (inertia.y() - inertia.z()) / inertia.x(),
          .coupling_q = (inertia.z() - inertia.x()) / inertia.y(),
          .coupling_r = (inertia.x() - inertia.y()) / inertia.z()};
}

template <class State>
VehicleState unpacked(const State& x) {
  VehicleState state;
  state.p_world = {x[0], x[1], x[2]};
  state.v_world = {x[3], x[4], x[5]};
  state.q_world_body = renormalised({x[6], x[7], x[8], x[9]});
  state.w_body = {x[10], x[11], x[12]};
  return state;
}

template <class State>
State packed(const VehicleState& s) {
  State x;
  x[0] = s.p_world.x(), x[1] = s.p_world.y(), x[2] = s.p_world.z();
  x[3] = s.v_world.x(), x[4] = s.v_world.y(), x[5] = s.v_world.z();
  x[6] = s.q_world_body.w(), x[7] = s.q_world_body.x();
  x[8] = s.q_world_body.y(), x[9] = s.q_world_body.z();
  x[10] = s.w_body.x(), x[11] = s.w_body.y(), x[12] = s.w_body.z();
  return x;
}

VehicleState step_lagged(const VehicleState& state, const RotorSpeeds& commanded,
                         const RigidBodyCoefficients& body, double lag_s, double period_s) {
  auto start = packed<LaggedState>(state);
  for (std::size_t i = 0; i < 4; ++i) start[kBodySize + i] = state.actuators[i];
  const double per_lag = 1 / lag_s;
  const LaggedState end = rk4_step(start, period_s, [&](const LaggedState& x) {
    LaggedState dx;
    RotorEffect rotors = rotor_effect(body, &x[kBodySize]);
    for (std::size_t i = 0; i < 4; ++i) {
      dx[kBodySize + i] = per_lag * (commanded[i] - x[kBodySize + i]);
    }
    const double* speedup = &dx[kBodySize];
    rotors.yaw_rad_s2 -= body.reaction * (speedup[0] - speedup[1] + speedup[2] - speedup[3]);
    body_derivative(x.data(), body, rotors, dx.data());
    return dx;
  });
  VehicleState next = unpacked(end);
  for (std::size_t i = 0; i < 4; ++i) next.actuators[i] = end[kBodySize + i];
  return next;
}

}  // namespace

Vec3 QuadrotorConfig::inertia_kg_m2() const {
  switch (inertia) {
    case InertiaSet::corrected:
      return {0.0081, 0.0081, 0.0142};
    case InertiaSet::printed:
      return {0.081, 0.081, 0.142};
    case InertiaSet::custom:
      break;
  }
  return {inertia_xx_kg_m2, inertia_yy_kg_m2, inertia_zz_kg_m2};
}

double QuadrotorConfig::hover_rotor_speed_rad_s() const {
  return std::sqrt(mass_kg * gravity_m_s2 / (4 * thrust_factor_N_s2));
}

double QuadrotorConfig::max_acceleration_m_s2(const MotionLimits& limits) const {
  return std::min(limits.max_acceleration_m_s2,
                  gravity_m_s2 * Sleef_cinz_tand1_u10purec(limits.max_tilt_rad));
}

Quadrotor::Quadrotor(const QuadrotorConfig& config)
    : config_(config),
      body_(coefficients_of(config)),
      hover_rad_s_(config.hover_rotor_speed_rad_s()) {
  if (hover_rad_s_ < config.min_rotor_speed_rad_s || hover_rad_s_ > config.max_rotor_speed_rad_s) {
    throw std::invalid_argument(
        "quadrotor: hovering takes " + std::to_string(hover_rad_s_) +
        " rad/s, which is outside min_rotor_speed_rad_s .. max_rotor_speed_rad_s (" +
        std::to_string(config.min_rotor_speed_rad_s) + " .. " +
        std::to_string(config.max_rotor_speed_rad_s) + ")");
  }
}

VehicleState Quadrotor::at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const {
  VehicleState state;
  state.p_world = p_world;
  state.q_world_body = level_attitude(heading_world);
  state.actuators = hold().u;
  return state;
}

Command Quadrotor::hold() const {
  return {{hover_rad_s_, hover_rad_s_, hover_rad_s_, hover_rad_s_}};
}

double Quadrotor::power_w(const VehicleState& state) const {
  double cubes = 0;
  for (const double w : state.actuators) cubes += w * w * w;
  return config_.drag_factor_N_m_s2 * cubes;
}

VehicleState Quadrotor::step(const VehicleState& state, const Command& command,
                             double period_s) const {
  RotorSpeeds speeds;
  for (std::size_t i = 0; i < 4; ++i) {
    speeds[i] =
        std::clamp(command.u[i], config_.min_rotor_speed_rad_s, config_.max_rotor_speed_rad_s);
  }
  if (config_.motor_lag_s > 0) {
    return step_lagged(state, speeds, body_, config_.motor_lag_s, period_s);
  }
  const RotorEffect rotors = rotor_effect(body_, speeds.data());
  VehicleState next = unpacked(rk4_step(packed<BodyState>(state), period_s, [&](const auto& x) {
    BodyState dx;
    body_derivative(x.data(), body_, rotors, dx.data());
    return dx;
  }));
  next.actuators = speeds;
  return next;
}

}  // namespace voronaut
