#include "voronaut/dynamics/regulators/guidance.h"

#include <algorithm>

#include "voronaut/dynamics/heading.h"

namespace voronaut {
namespace {

constexpr double kMaxClimb_m_s = 1;

}  // namespace

Eigen::Vector2d desired_velocity(const Setpoint& setpoint, const VehicleState& state,
                                 const SpeedProfile& profile, double max_speed_m_s) {
  if (const auto* command = std::get_if<VelocityCommand>(&setpoint.motion))
    return command->v_world_m_s;
  const Eigen::Vector2d p = state.p_world.head<2>();
  if (const auto* rest = std::get_if<RestAtTarget>(&setpoint.motion))
    return profile.velocity_m_s(rest->p_world - p, std::min(rest->speed_limit_m_s, max_speed_m_s));
  if (const auto* pass = std::get_if<PassTarget>(&setpoint.motion)) {
    const Eigen::Vector2d to_target = pass->p_world - p;
    const double distance_m = to_target.norm();
    if (distance_m == 0) return Eigen::Vector2d::Zero();
    return to_target * (std::min(pass->speed_limit_m_s, max_speed_m_s) / distance_m);
  }
  return std::get<ArcCommand>(setpoint.motion).v_m_s * state.heading_world();
}

double desired_climb_m_s(const Setpoint& setpoint, const VehicleState& state, double gain_1_s) {
  const double error_m = setpoint.height_m - state.p_world.z();
  return std::clamp(gain_1_s * error_m, -kMaxClimb_m_s, kMaxClimb_m_s);
}

double desired_yaw_rate_rad_s(const Setpoint& setpoint, const Eigen::Vector2d& heading_world,
                              double gain_1_s, double max_yaw_rate_rad_s) {
  const double error_rad = heading_error_rad(heading_world, setpoint.heading_world);
  return std::clamp(gain_1_s * error_rad + setpoint.yaw_rate_rad_s, -max_yaw_rate_rad_s,
                    max_yaw_rate_rad_s);
}

}  // namespace voronaut
