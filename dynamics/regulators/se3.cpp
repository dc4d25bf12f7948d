#include "voronaut/dynamics/regulators/se3.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"
#include "voronaut/dynamics/regulators/thrust_vectoring.h"
#include "voronaut/dynamics/regulators/tilt_response.h"

namespace voronaut {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Se3Gains = Se3Config::Gains;

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kSe3StopErrorAtRest_m = 0.018;
constexpr double kAgileSe3StopError_s = 0.016;
constexpr double kSluggishSe3StopError_s = 0.05;

// Of a_max, in the mean over a stop: while the axis turns F . R e3 gives less than the tilt will.
constexpr double kMeanDeceleration = 0.9;
// Of the weight: what F keeps upwards, so that no vehicle turns over to sink faster.
constexpr double kLeastLift = 0.3;

Se3Config with_gains(Se3Config config, const QuadrotorConfig& vehicle) {
  const bool printed = config.gains == Se3Gains::printed ||
                       (config.gains == Se3Gains::by_inertia &&
                        vehicle.inertia == QuadrotorConfig::InertiaSet::printed);
  if (config.gains == Se3Gains::custom) return config;
  config.velocity_gain_1_s = printed ? 1.6 : 2;
  config.attitude_pole_rad_s = printed ? 7 : 10;
  config.attitude_damping = 0.9;
  return config;
}

// The attitude with its z axis along F that looks, as seen from above, along `ahead_world`.
Matrix3d attitude_with(const Vec3& f, const Vector2d& ahead_world) {
  const Vec3 b1d(ahead_world.x(), ahead_world.y(), 0);
  Matrix3d r;
  r.col(2) = f.normalized();
  r.col(1) = r.col(2).cross(b1d).normalized();
  r.col(0) = r.col(1).cross(r.col(2));
  return r;
}

Vec3 vee(const Matrix3d& skew) { return {skew(2, 1), skew(0, 2), skew(1, 0)}; }

}  // namespace

Se3::Se3(const Se3Config& config, const QuadrotorConfig& vehicle, const MotionLimits& limits,
         double period_s)
    : config_(with_gains(config, vehicle)),
      vehicle_(vehicle),
      limits_(limits),
      period_s_(period_s),
      profile_(config.profile),
      allocation_(vehicle),
      inertia_kg_m2_(vehicle.inertia_kg_m2()),
      max_acceleration_m_s2_(vehicle.max_acceleration_m_s2(limits)) {}

Vec3 Se3::force_per_mass(const Setpoint& setpoint, const VehicleState& state) const {
  const double g = vehicle_.gravity_m_s2;
  const double climb_error =
      desired_climb_m_s(setpoint, state, config_.height_gain_1_s) - state.v_world.z();
  const double lift = std::max(g + config_.climb_gain_1_s * climb_error, kLeastLift * g);
  // With less lift the same tilt gives less acceleration.
  const Vector2d a = desired_acceleration(
      desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s), state.v_world.head<2>(),
      config_.velocity_gain_1_s, max_acceleration_m_s2_ * std::min(1.0, lift / g));
  return {a.x(), a.y(), lift};
}

Command Se3::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const Vec3 f = force_per_mass(setpoint, state);
  const Vector2d ahead = state.heading_world();
  const Matrix3d r = state.q_world_body.toRotationMatrix();
  const Matrix3d to_desired = r.transpose() * attitude_with(f, ahead);  // R' Rd
  const double yaw_rate =
      desired_yaw_rate_rad_s(setpoint, ahead, config_.yaw_gain_1_s, limits_.max_yaw_rate_rad_s);

  const Vec3& w = state.w_body;
  const Vec3 w_desired(0, 0, yaw_rate);
  const Vec3 attitude_error = 0.5 * vee(to_desired.transpose() - to_desired);
  const Vec3 rate_error = w - w_desired;
  const double pole = config_.attitude_pole_rad_s;
  Vec3 turn = straight_tilt(w) - pole * pole * attitude_error -
              2 * config_.attitude_damping * pole * rate_error;
  turn.z() = -config_.yaw_rate_gain_1_s * rate_error.z();
  return allocation_.speeds({.thrust_N = vehicle_.mass_kg * f.dot(r.col(2)),
                             .torque_N_m = torque_for(turn, w, inertia_kg_m2_)});
}

StoppingLaw Se3::stopping_law() const {
  return {config_.velocity_gain_1_s, kMeanDeceleration * max_acceleration_m_s2_};
}

VelocityResponse Se3::velocity_response() const {
  const TiltLoop loop{config_.velocity_gain_1_s,
                      config_.attitude_pole_rad_s * config_.attitude_pole_rad_s,
                      2 * config_.attitude_damping * config_.attitude_pole_rad_s};
  return tilt_response(vehicle_, limits_, loop,
                       {kSe3StopErrorAtRest_m, kAgileSe3StopError_s, kSluggishSe3StopError_s},
                       period_s_);
}

}  // namespace voronaut
