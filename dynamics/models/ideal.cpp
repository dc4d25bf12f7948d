#include "voronaut/dynamics/models/ideal.h"

#include <algorithm>

#include <sleef.h>

#include "voronaut/dynamics/attitude.h"

namespace voronaut {

VehicleState Ideal::at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const {
  VehicleState state;
  state.p_world = p_world;
  state.q_world_body = level_attitude(heading_world);
  return state;
}

VehicleState Ideal::step(const VehicleState& state, const Command& command, double period_s) const {
  Vec3 acceleration(command.u[0], command.u[1], command.u[2]);
  const double norm = acceleration.norm();
  if (norm > config_.max_acceleration_m_s2) acceleration *= config_.max_acceleration_m_s2 / norm;
  const double yaw_rate =
      std::clamp(command.u[3], -config_.max_yaw_rate_rad_s, config_.max_yaw_rate_rad_s);

  VehicleState next = state;
  next.p_world += period_s * (state.v_world + 0.5 * period_s * acceleration);
  next.v_world += period_s * acceleration;
  next.w_body = {0, 0, yaw_rate};
  if (yaw_rate != 0) {
    const Sleef_double_2 half = Sleef_cinz_sincosd1_u10purec(0.5 * period_s * yaw_rate);
    const double w = state.q_world_body.w();
    const double z = state.q_world_body.z();
    next.q_world_body = renormalised({w * half.y - z * half.x, 0, 0, w * half.x + z * half.y});
  }
  return next;
}

}  // namespace voronaut
