#include "voronaut/dynamics/models/quadrotor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

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

// What the rotors do to the body, as accelerations: eq. (2) divided by mass and inertia, and the
// gyroscopic coefficients of eq. (1).
struct RotorEffect {
  double thrust_m_s2;
  double roll_rad_s2, pitch_rad_s2, yaw_rad_s2;
  double gyro_p_1_s, gyro_q_1_s;  // J_TP Omega / I_xx, / I_yy
};

RotorEffect rotor_effect(const QuadrotorConfig& c, const Vec3& inertia, const double* w) {
  const double s1 = w[0] * w[0], s2 = w[1] * w[1], s3 = w[2] * w[2], s4 = w[3] * w[3];
  const double b = c.thrust_factor_N_s2;
  const double spin = c.rotor_inertia_kg_m2 * (w[0] - w[1] + w[2] - w[3]);
  return {.thrust_m_s2 = b * (s1 + s2 + s3 + s4) / c.mass_kg,
          .roll_rad_s2 = b * c.arm_m * (s4 - s2) / inertia.x(),
          .pitch_rad_s2 = b * c.arm_m * (s3 - s1) / inertia.y(),
          .yaw_rad_s2 = c.drag_factor_N_m_s2 * (s2 + s4 - s1 - s3) / inertia.z(),
          .gyro_p_1_s = spin / inertia.x(),
          .gyro_q_1_s = spin / inertia.y()};
}

// Constant coefficients of the body's equations.
struct Body {
  double gravity_m_s2, drag_1_s;
  double coupling_p, coupling_q, coupling_r;  // (I_yy - I_zz)/I_xx and so on
};

// Eq. (1) with the exact quaternion kinematics q' = q (0, w) / 2.
inline void body_derivative(const double* x, const Body& body, const RotorEffect& rotors,
                            double* dx) {
  const double vx = x[3], vy = x[4], vz = x[5];
  const double qw = x[6], qx = x[7], qy = x[8], qz = x[9];
  const double p = x[10], q = x[11], r = x[12];
  const double twice_thrust = 2 * rotors.thrust_m_s2;
  dx[0] = vx;
  dx[1] = vy;
  dx[2] = vz;
  dx[3] = twice_thrust * (qx * qz + qw * qy) - body.drag_1_s * vx;
  dx[4] = twice_thrust * (qy * qz - qw * qx) - body.drag_1_s * vy;
  dx[5] = rotors.thrust_m_s2 - twice_thrust * (qx * qx + qy * qy) - body.gravity_m_s2 -
          body.drag_1_s * vz;
  const double hp = 0.5 * p, hq = 0.5 * q, hr = 0.5 * r;
  dx[6] = -qx * hp - qy * hq - qz * hr;
  dx[7] = qw * hp + qy * hr - qz * hq;
  dx[8] = qw * hq + qz * hp - qx * hr;
  dx[9] = qw * hr + qx * hq - qy * hp;
  dx[10] = body.coupling_p * q * r - rotors.gyro_p_1_s * q + rotors.roll_rad_s2;
  dx[11] = body.coupling_q * p * r + rotors.gyro_q_1_s * p + rotors.pitch_rad_s2;
  dx[12] = body.coupling_r * p * q + rotors.yaw_rad_s2;
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
                         const QuadrotorConfig& config, const Vec3& inertia, const Body& body,
                         double period_s) {
  auto start = packed<LaggedState>(state);
  for (std::size_t i = 0; i < 4; ++i) start[kBodySize + i] = state.actuators[i];
  const double per_lag = 1 / config.motor_lag_s;
  const double reaction =
      config.rotor_acceleration_torque ? config.rotor_inertia_kg_m2 / inertia.z() : 0;
  const LaggedState end = rk4_step(start, period_s, [&](const LaggedState& x) {
    LaggedState dx;
    RotorEffect rotors = rotor_effect(config, inertia, &x[kBodySize]);
    for (std::size_t i = 0; i < 4; ++i) {
      dx[kBodySize + i] = per_lag * (commanded[i] - x[kBodySize + i]);
    }
    const double* speedup = &dx[kBodySize];
    rotors.yaw_rad_s2 -= reaction * (speedup[0] - speedup[1] + speedup[2] - speedup[3]);
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

Quadrotor::Quadrotor(const QuadrotorConfig& config)
    : config_(config),
      inertia_kg_m2_(config.inertia_kg_m2()),
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

VehicleState Quadrotor::step(const VehicleState& state, const Command& command,
                             double period_s) const {
  RotorSpeeds speeds;
  for (std::size_t i = 0; i < 4; ++i) {
    speeds[i] =
        std::clamp(command.u[i], config_.min_rotor_speed_rad_s, config_.max_rotor_speed_rad_s);
  }
  const Vec3& inertia = inertia_kg_m2_;
  const Body body{.gravity_m_s2 = config_.gravity_m_s2,
                  .drag_1_s = config_.linear_drag_1_s,
                  .coupling_p = (inertia.y() - inertia.z()) / inertia.x(),
                  .coupling_q = (inertia.z() - inertia.x()) / inertia.y(),
                  .coupling_r = (inertia.x() - inertia.y()) / inertia.z()};
  if (config_.motor_lag_s > 0) {
    return step_lagged(state, speeds, config_, inertia, body, period_s);
  }
  const RotorEffect rotors = rotor_effect(config_, inertia, speeds.data());
  VehicleState next = unpacked(rk4_step(packed<BodyState>(state), period_s, [&](const auto& x) {
    BodyState dx;
    body_derivative(x.data(), body, rotors, dx.data());
    return dx;
  }));
  next.actuators = speeds;
  return next;
}

}  // namespace voronaut
