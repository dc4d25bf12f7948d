#pragma once

#include <Eigen/Core>

#include "voronaut/dynamics/speed_profile.h"
#include "voronaut/dynamics/state.h"

// What every regulator reads from a setpoint.
namespace voronaut {

// Horizontal velocity asked for, in world axes: towards the target at the speed limit (never above
// `max_speed_m_s`), or slowing down by the profile if the target is to be rested at. Eqs. (5), (6)
// of the quadrotor planner paper; zero at the target.
Eigen::Vector2d desired_velocity(const Setpoint& setpoint, const VehicleState& state,
                                 const SpeedProfile& profile, double max_speed_m_s);

// Vertical speed asked for: gain times the error of height, clipped to +-1 m/s.
double desired_climb_m_s(const Setpoint& setpoint, const VehicleState& state, double gain_1_s);

// Angle from one heading to another (unit vectors), in (-2.4, 2.4), positive to the left, without a
// transcendental: s (1 + s^2/24) with s = 2 sin(e/2), the first two terms of 2 asin(s/2). Short by
// 3e-4 of itself at 0.5 rad, 2.5 % at 90 deg, 26 % at 180 deg; exactly opposite headings turn left.
double heading_error_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

// Turning rate asked for: gain times the heading error plus the setpoint's feedforward, clipped.
double desired_yaw_rate_rad_s(const Setpoint& setpoint, const Eigen::Vector2d& heading_world,
                              double gain_1_s, double max_yaw_rate_rad_s);

}  // namespace voronaut
