#pragma once

#include <Eigen/Core>

#include "voronaut/dynamics/speed_profile.h"
#include "voronaut/dynamics/state.h"

// What every regulator reads from a setpoint.
namespace voronaut {

// Horizontal velocity asked for, in world axes: towards the target at the speed limit (never above
// `max_speed_m_s`), or slowing down by the profile if the target is to be rested at. Eqs. (5), (6)
// of the quadrotor planner paper; zero at the target. A velocity command is obeyed as it
// is, and of an arc its speed along the heading.
Eigen::Vector2d desired_velocity(const Setpoint& setpoint, const VehicleState& state,
                                 const SpeedProfile& profile, double max_speed_m_s);

// Vertical speed asked for: gain times the error of height, clipped to +-1 m/s.
double desired_climb_m_s(const Setpoint& setpoint, const VehicleState& state, double gain_1_s);

// Turning rate asked for: gain times the heading error plus the setpoint's feedforward, clipped.
double desired_yaw_rate_rad_s(const Setpoint& setpoint, const Eigen::Vector2d& heading_world,
                              double gain_1_s, double max_yaw_rate_rad_s);

}  // namespace voronaut
