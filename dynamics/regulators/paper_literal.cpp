#include "voronaut/dynamics/regulators/paper_literal.h"

#include "voronaut/dynamics/regulators/guidance.h"
#include "voronaut/dynamics/regulators/rotor_mixing.h"

namespace voronaut {

PaperLiteral::PaperLiteral(const PaperLiteralConfig& config, const QuadrotorConfig& vehicle,
                           const MotionLimits& limits, double period_s)
    : config_(config),
      limits_(limits),
      period_s_(period_s),
      profile_(config.profile),
      hover_rad_s_(vehicle.hover_rotor_speed_rad_s()) {}

void PaperLiteral::reset(const VehicleState& state) {
  ahead_world_ = state.heading_world();
  previous_ = state;
}

Command PaperLiteral::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const Eigen::Vector2d v_desired =
      desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s);
  const Eigen::Vector2d push =
      config_.horizontal_kp * (v_desired - state.v_world.head<2>()) -
      config_.horizontal_kd / period_s_ * (state.v_world - previous_.v_world).head<2>();

  RotorDemand demand;
  demand.collective = hover_rad_s_ + config_.height_kp * (setpoint.height_m - state.p_world.z()) -
                      config_.height_kd / period_s_ * (state.p_world.z() - previous_.p_world.z());
  demand.forward = push.dot(ahead_world_);
  demand.right = push.x() * ahead_world_.y() - push.y() * ahead_world_.x();
  previous_ = state;
  return mixed(demand, config_.typo_in_eq3);
}

}  // namespace voronaut
