#include "voronaut/dynamics/regulators/lqr.h"

#include "voronaut/dynamics/regulators/guidance.h"
#include "voronaut/dynamics/regulators/lqr_gains.h"
#include "voronaut/dynamics/regulators/thrust_vectoring.h"
#include "voronaut/dynamics/regulators/tilt_response.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using LqrGains = LqrConfig::Gains;

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kLqrStopErrorAtRest_m = 0.018;
constexpr double kAgileLqrStopError_s = 0.011;
constexpr double kSluggishLqrStopError_s = 0.05;

LqrConfig with_gains(LqrConfig config, const QuadrotorConfig& vehicle) {
  const bool printed = config.gains == LqrGains::printed ||
                       (config.gains == LqrGains::by_inertia &&
                        vehicle.inertia == QuadrotorConfig::InertiaSet::printed);
  if (config.gains == LqrGains::custom) return config;
  const auto& k = printed ? lqr_gains::kPrinted.k : lqr_gains::kCorrected.k;
  config.velocity_gain_1_s3 = k[0];
  config.acceleration_gain_1_s2 = k[1];
  config.jerk_gain_1_s = k[2];
  return config;
}

}  // namespace

Lqr::Lqr(const LqrConfig& config, const QuadrotorConfig& vehicle, const MotionLimits& limits,
         double period_s)
    : config_(with_gains(config, vehicle)),
      vehicle_(vehicle),
      limits_(limits),
      period_s_(period_s),
      profile_(config.profile),
      allocation_(vehicle),
      inertia_kg_m2_(vehicle.inertia_kg_m2()),
      max_acceleration_m_s2_(vehicle.max_acceleration_m_s2(limits)) {}

Command Lqr::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const auto& [height_k, climb_k] = lqr_gains::kHeight.k;
  const auto& [heading_k, yaw_rate_k] = lqr_gains::kYaw.k;
  const double g = vehicle_.gravity_m_s2;
  const Vec3 axis_world = thrust_axis(state);
  const double cosine = bounded_cosine(axis_world);
  const Vector2d a_desired =
      desired_acceleration(desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s),
                           state.v_world.head<2>(), stopping_law().k_1_s, max_acceleration_m_s2_);
  const Vector2d a = (g / cosine) * axis_world.head<2>();

  // A turn of the thrust changes the acceleration by g / cos^2.
  const Vector2d push = (config_.acceleration_gain_1_s2 * cosine * cosine / g) * (a_desired - a);
  const Vector2d ahead = state.heading_world();
  const double climb_error =
      desired_climb_m_s(setpoint, state, height_k / climb_k) - state.v_world.z();
  const double yaw_rate =
      desired_yaw_rate_rad_s(setpoint, ahead, heading_k / yaw_rate_k, limits_.max_yaw_rate_rad_s);
  const Vec3& w = state.w_body;
  Vec3 turn = straight_tilt(w);
  turn.x() += push.x() * ahead.y() - push.y() * ahead.x() - config_.jerk_gain_1_s * w.x();
  turn.y() += push.dot(ahead) - config_.jerk_gain_1_s * w.y();
  turn.z() = yaw_rate_k * (yaw_rate - w.z());
  return allocation_.speeds(
      {.thrust_N = thrust_carrying(vehicle_.mass_kg * (g + climb_k * climb_error), axis_world),
       .torque_N_m = torque_for(turn, w, inertia_kg_m2_)});
}

StoppingLaw Lqr::stopping_law() const {
  return {config_.velocity_gain_1_s3 / config_.acceleration_gain_1_s2, max_acceleration_m_s2_};
}

VelocityResponse Lqr::velocity_response() const {
  const TiltLoop loop{stopping_law().k_1_s, config_.acceleration_gain_1_s2, config_.jerk_gain_1_s};
  return tilt_response(vehicle_, limits_, loop,
                       {kLqrStopErrorAtRest_m, kAgileLqrStopError_s, kSluggishLqrStopError_s},
                       period_s_);
}

}  // namespace voronaut
