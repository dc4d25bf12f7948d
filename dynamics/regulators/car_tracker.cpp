#include "voronaut/dynamics/regulators/car_tracker.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"

namespace voronaut {
namespace {

// Of what the car may accelerate at all, across its course.
constexpr double kLateralShareOfCar = 0.6;
constexpr double kCarGainPerStepMax = 0.25;
// Nearer than this, the direction of a target says nothing.
constexpr double kAtTarget_m = 0.05;
// Bounds of CarResponse::error_m that tests/dynamics/car_response_test.cpp holds.
constexpr double kCarErrorAtRest_m = 0.001;
constexpr double kCarError_s = 0.001;

}  // namespace

CarTracker::CarTracker(const CarTrackerConfig& config, const CarConfig& vehicle,
                       const MotionLimits& limits, double period_s)
    : profile_(config.profile) {
  const double gain_max_1_s = kCarGainPerStepMax / period_s;
  CarResponse& r = response_;
  r.period_s = period_s;
  r.speed_gain_1_s = std::min(config.speed_gain_1_s, gain_max_1_s);
  r.a_max_m_s2 = std::min(limits.max_acceleration_m_s2, vehicle.max_acceleration_m_s2);
  r.steering_gain_1_s = std::min(config.steering_gain_1_s, gain_max_1_s);
  r.steering_rate_max_rad_s = vehicle.max_steering_rate_rad_s;
  r.steering_max_rad = vehicle.max_steering_rad;
  r.wheelbase_m = vehicle.wheelbase_m;
  r.max_speed_m_s = limits.max_speed_m_s;
  r.max_lateral_m_s2 = kLateralShareOfCar * r.a_max_m_s2;
  r.error_at_rest_m = kCarErrorAtRest_m;
  r.error_per_speed_s = kCarError_s;
}

ArcCommand CarTracker::wanted(const Setpoint& setpoint, const VehicleState& state) const {
  if (const auto* arc = std::get_if<ArcCommand>(&setpoint.motion)) return *arc;
  const CarMotion now = response_.motion_of(state);
  const Eigen::Vector2d v_m_s =
      desired_velocity(setpoint, state, profile_, response_.max_speed_m_s);
  if (v_m_s.norm() == 0) return {};
  Eigen::Vector2d way_m = v_m_s.normalized();
  if (const auto* pass = std::get_if<PassTarget>(&setpoint.motion)) way_m = pass->p_world - now.p_m;
  if (const auto* rest = std::get_if<RestAtTarget>(&setpoint.motion)) {
    way_m = rest->p_world - now.p_m;
    if (way_m.norm() < kAtTarget_m) return {v_m_s.dot(now.heading), 0};
  }
  return steered_towards(now, way_m, v_m_s.norm(), response_);
}

Command CarTracker::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const CarResponse::Rates rates =
      response_.rates_asked(response_.motion_of(state), wanted(setpoint, state));
  return {{rates.v_dot_m_s2, rates.steering_dot_rad_s, 0, 0}};
}

StoppingLaw CarTracker::stopping_law() const {
  return {response_.speed_gain_1_s, response_.a_max_m_s2};
}

}  // namespace voronaut
