#include "voronaut/dynamics/regulators/ideal.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"

namespace voronaut {
namespace {

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kIdealStopErrorAtRest_m = 0.006;
constexpr double kStopError_s = 0.001;

}  // namespace

IdealRegulator::IdealRegulator(const IdealRegulatorConfig& config, const IdealConfig& vehicle,
                               const MotionLimits& limits, double period_s)
    : config_(config),
      limits_(limits),
      period_s_(period_s),
      vehicle_acceleration_m_s2_(vehicle.max_acceleration_m_s2),
      profile_(config.profile) {}

Command IdealRegulator::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const double a_max = limits_.max_acceleration_m_s2;
  const double climb_error =
      desired_climb_m_s(setpoint, state, config_.height_gain_1_s) - state.v_world.z();
  const double vertical = std::clamp(config_.climb_gain_1_s * climb_error, -a_max, a_max);

  const Eigen::Vector2d v_desired =
      desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s);
  Eigen::Vector2d horizontal = config_.velocity_gain_1_s * (v_desired - state.v_world.head<2>());
  const double room = std::sqrt(std::max(a_max * a_max - vertical * vertical, 0.0));
  const double norm = horizontal.norm();
  if (norm > room) horizontal *= room / norm;

  const double yaw_rate = desired_yaw_rate_rad_s(setpoint, state.heading_world(),
                                                 config_.yaw_gain_1_s, limits_.max_yaw_rate_rad_s);
  return {{horizontal.x(), horizontal.y(), vertical, yaw_rate}};
}

StoppingLaw IdealRegulator::stopping_law() const {
  return {config_.velocity_gain_1_s,
          std::min(limits_.max_acceleration_m_s2, vehicle_acceleration_m_s2_)};
}

VelocityResponse IdealRegulator::velocity_response() const {
  const StoppingLaw law = stopping_law();
  VelocityResponse response;
  response.period_s = period_s_;
  response.k_1_s = law.k_1_s;
  response.a_max_m_s2 = law.a_m_s2;
  response.error_at_rest_m = kIdealStopErrorAtRest_m;
  response.error_per_speed_s = kStopError_s;
  return response;
}

}  // namespace voronaut
