#include "voronaut/dynamics/regulators/arc_tracker.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace voronaut {
namespace {

// Of what the vehicle may accelerate at all, across its course.
constexpr double kLateralShare = 0.6;
// Of a loop with one step of delay: more would overshoot.
constexpr double kGainPerStepMax = 0.25;
// Nearer than this, the direction of a target says nothing: it comes to rest abeam of it.
constexpr double kAbeam_m = 0.05;
// The direction of a velocity, as a point to drive to.
constexpr double kCourse_s = 1;
// Bounds of DriveResponse::error_m that tests/dynamics/drive_response_test.cpp holds.
constexpr double kArcStopErrorAtRest_m = 0.002;
constexpr double kArcStopError_s = 0.002;

DriveResponse response_of(const ArcTrackerConfig& config, const UnicycleConfig& vehicle,
                          const MotionLimits& limits, double period_s) {
  const double gain_max_1_s = kGainPerStepMax / period_s;
  DriveResponse r;
  r.period_s = period_s;
  r.speed_gain_1_s = std::min(config.speed_gain_1_s, gain_max_1_s);
  r.a_max_m_s2 = std::min(limits.max_acceleration_m_s2, vehicle.max_acceleration_m_s2);
  r.yaw_rate_gain_1_s = std::min(config.yaw_rate_gain_1_s, gain_max_1_s);
  r.alpha_max_rad_s2 = vehicle.max_yaw_acceleration_rad_s2;
  r.limits = {.max_speed_m_s = std::min(limits.max_speed_m_s, vehicle.max_speed_m_s),
              .max_yaw_rate_rad_s = std::min(limits.max_yaw_rate_rad_s, vehicle.max_yaw_rate_rad_s),
              .max_lateral_m_s2 = kLateralShare * r.a_max_m_s2,
              .turn_gain_1_s = config.turn_gain_1_s};
  r.error_at_rest_m = kArcStopErrorAtRest_m;
  r.error_per_speed_s = kArcStopError_s;
  return r;
}

// A lag answers a step within the period T by 1 - exp(-T / lag) of it.
double undoing_lag_s(double lag_s, double period_s) {
  if (lag_s == 0) return period_s;
  return period_s / (1 - Sleef_cinz_expd1_u10purec(-period_s / lag_s));
}

}  // namespace

ArcTracker::ArcTracker(const ArcTrackerConfig& config, const UnicycleConfig& vehicle,
                       const MotionLimits& limits, double period_s)
    : response_(response_of(config, vehicle, limits, period_s)),
      undo_lag_s_(undoing_lag_s(vehicle.drive_lag_s, period_s)),
      profile_(config.profile) {}

void ArcTracker::reset(const VehicleState&) { v_dot_given_m_s2_ = w_dot_given_rad_s2_ = 0; }

ArcCommand ArcTracker::rest_at(const RestAtTarget& target, const DriveMotion& now) const {
  const ArcLimits& limits = response_.limits;
  const Eigen::Vector2d way_m = target.p_world - now.p_m;
  const Eigen::Vector2d v_m_s =
      profile_.velocity_m_s(way_m, std::min(target.speed_limit_m_s, limits.max_speed_m_s));
  if (way_m.norm() < kAbeam_m) return {v_m_s.dot(now.heading), 0};
  return arc_towards(now.heading, way_m, v_m_s.norm(), now.v_m_s, limits);
}

ArcCommand ArcTracker::wanted(const Setpoint& setpoint, const VehicleState& state) const {
  if (const auto* arc = std::get_if<ArcCommand>(&setpoint.motion)) return *arc;
  const ArcLimits& limits = response_.limits;
  const DriveMotion now = response_.motion_of(state);
  if (const auto* command = std::get_if<VelocityCommand>(&setpoint.motion)) {
    return arc_towards(now.heading, kCourse_s * command->v_world_m_s, command->v_world_m_s.norm(),
                       now.v_m_s, limits);
  }
  const auto* pass = std::get_if<PassTarget>(&setpoint.motion);
  const auto* rest = std::get_if<RestAtTarget>(&setpoint.motion);
  const double speed_limit_m_s = pass ? pass->speed_limit_m_s : rest->speed_limit_m_s;
  if (speed_limit_m_s <= 0) {
    return {0,
            turn_rate_rad_s(now.heading, setpoint.heading_world, setpoint.yaw_rate_rad_s, limits)};
  }
  if (rest) return rest_at(*rest, now);
  return arc_towards(now.heading, pass->p_world - now.p_m,
                     std::min(speed_limit_m_s, limits.max_speed_m_s), now.v_m_s, limits);
}

Command ArcTracker::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const DriveResponse& r = response_;
  const ArcCommand arc = wanted(setpoint, state);
  const DriveMotion now = r.motion_of(state);
  const double v_dot =
      std::clamp(r.speed_gain_1_s * (arc.v_m_s - now.v_m_s), -r.a_max_m_s2, r.a_max_m_s2);
  const double w_dot = std::clamp(r.yaw_rate_gain_1_s * (arc.w_rad_s - now.w_rad_s),
                                  -r.alpha_max_rad_s2, r.alpha_max_rad_s2);
  // What it will have when this command begins to act, and what it shall have gained by its end.
  const Command command{{now.v_m_s + r.period_s * v_dot_given_m_s2_ + undo_lag_s_ * v_dot,
                         now.w_rad_s + r.period_s * w_dot_given_rad_s2_ + undo_lag_s_ * w_dot, 0,
                         0}};
  v_dot_given_m_s2_ = v_dot;
  w_dot_given_rad_s2_ = w_dot;
  return command;
}

StoppingLaw ArcTracker::stopping_law() const {
  return {response_.speed_gain_1_s, response_.a_max_m_s2};
}

}  // namespace voronaut
