#include "voronaut/dynamics/regulators/cascade_pid.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"
#include "voronaut/dynamics/regulators/thrust_vectoring.h"
#include "voronaut/dynamics/regulators/tilt_response.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using CascadeGains = CascadePidConfig::Gains;

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kCascadeStopErrorAtRest_m = 0.016;
constexpr double kAgileCascadeStopError_s = 0.005;
constexpr double kSluggishCascadeStopError_s = 0.045;  // on the printed inertia the rotors saturate

// 2 sin(e/2) about the axis that turns the body's z axis to `wanted` (unit vector, body axes): the
// error e of the tilt, and the most where `wanted` lies below.
Vector2d tilt_error(const Vec3& wanted) {
  constexpr double kOpposite = 1e-9;
  const double one_and_cosine = 1 + wanted.z();
  if (one_and_cosine < kOpposite) return {2, 0};
  return Vector2d(-wanted.y(), wanted.x()) * std::sqrt(2 / one_and_cosine);
}

// The config with the gains that its set says.
CascadePidConfig with_gains(CascadePidConfig config, const QuadrotorConfig& vehicle) {
  const bool printed = config.gains == CascadeGains::printed ||
                       (config.gains == CascadeGains::by_inertia &&
                        vehicle.inertia == QuadrotorConfig::InertiaSet::printed);
  if (config.gains == CascadeGains::custom) return config;
  config.velocity_gain_1_s = printed ? 1.5 : 3;
  config.attitude_gain_1_s = printed ? 4.5 : 8;
  config.rate_gain_1_s = printed ? 12 : 20;
  return config;
}

}  // namespace

CascadePid::CascadePid(const CascadePidConfig& config, const QuadrotorConfig& vehicle,
                       const MotionLimits& limits, double period_s)
    : config_(with_gains(config, vehicle)),
      vehicle_(vehicle),
      limits_(limits),
      period_s_(period_s),
      profile_(config.profile),
      allocation_(vehicle),
      inertia_kg_m2_(vehicle.inertia_kg_m2()),
      max_acceleration_m_s2_(vehicle.max_acceleration_m_s2(limits)) {}

void CascadePid::reset(const VehicleState&) {
  before_.reset();
  at_limit_ = false;
  unexplained_m_s2_.setZero();
}

void CascadePid::learn_unexplained(const VehicleState& state, const Vec3& axis_world) {
  if (before_ && !at_limit_) {
    double squares = 0;
    for (const double w : state.actuators) squares += w * w;
    const double thrust_m_s2 = vehicle_.thrust_factor_N_s2 * squares / vehicle_.mass_kg;
    const Vec3 explained = (0.5 * thrust_m_s2) * (before_->axis_world + axis_world) -
                           vehicle_.gravity_m_s2 * Vec3::UnitZ();
    const Vec3 measured = (state.v_world - before_->v_world) / period_s_;
    unexplained_m_s2_ += std::min(1.0, config_.integral_gain_1_s * period_s_) *
                         (measured - explained - unexplained_m_s2_);
    const double norm = unexplained_m_s2_.norm();
    if (norm > config_.integral_limit_m_s2) unexplained_m_s2_ *= config_.integral_limit_m_s2 / norm;
  }
  before_ = {state.v_world, axis_world};
}

Command CascadePid::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const Vec3 axis_world = thrust_axis(state);
  learn_unexplained(state, axis_world);

  const Vector2d v_world = state.v_world.head<2>();
  const Vector2d v_desired = desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s);
  const Vector2d v_reached = v_world + unexplained_m_s2_.head<2>() / config_.velocity_gain_1_s;
  const Vector2d a_desired =
      desired_acceleration(v_desired, v_reached, config_.velocity_gain_1_s, max_acceleration_m_s2_);
  at_limit_ = config_.velocity_gain_1_s * (v_desired - v_reached).norm() > max_acceleration_m_s2_;

  const double climb_error =
      desired_climb_m_s(setpoint, state, config_.height_gain_1_s) - state.v_world.z();
  const double lift_m_s2 =
      vehicle_.gravity_m_s2 + config_.climb_gain_1_s * climb_error - unexplained_m_s2_.z();

  const Vec3 wanted = Vec3(a_desired.x(), a_desired.y(), vehicle_.gravity_m_s2).normalized();
  const Vector2d tilt_rate =
      config_.attitude_gain_1_s * tilt_error(state.q_world_body.conjugate() * wanted);
  const double yaw_rate = desired_yaw_rate_rad_s(setpoint, state.heading_world(),
                                                 config_.yaw_gain_1_s, limits_.max_yaw_rate_rad_s);
  Vec3 turn = straight_tilt(state.w_body);
  turn.head<2>() += config_.rate_gain_1_s * (tilt_rate - state.w_body.head<2>());
  turn.z() = config_.yaw_rate_gain_1_s * (yaw_rate - state.w_body.z());
  return allocation_.speeds({.thrust_N = thrust_carrying(vehicle_.mass_kg * lift_m_s2, axis_world),
                             .torque_N_m = torque_for(turn, state.w_body, inertia_kg_m2_)});
}

StoppingLaw CascadePid::stopping_law() const {
  return {config_.velocity_gain_1_s, max_acceleration_m_s2_};
}

VelocityResponse CascadePid::velocity_response() const {
  const TiltLoop loop{config_.velocity_gain_1_s, config_.attitude_gain_1_s * config_.rate_gain_1_s,
                      config_.rate_gain_1_s};
  return tilt_response(
      vehicle_, limits_, loop,
      {kCascadeStopErrorAtRest_m, kAgileCascadeStopError_s, kSluggishCascadeStopError_s},
      period_s_);
}

}  // namespace voronaut
