#include "voronaut/dynamics/regulators/position_trajectory.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;

// A turn on the spot begins when the way lies behind and ends when it is within 20 deg of ahead.
constexpr double kTurnedCosine = 0.94;
constexpr double kSlow_m_s = 0.1;
// Of the gradient of psi, 1 on the curve: nearer to the centre of an arc it has no direction.
constexpr double kNoDirection = 1e-3;

// Of what it may accelerate at all, across the course of an arc.
constexpr double kLateralShareOfCart = 0.6;
// Bounds of DriveResponse::error_m that tests/dynamics/drive_response_test.cpp holds.
constexpr double kCartStopErrorAtRest_m = 0.001;
constexpr double kCartStopError_s = 0.001;

// Puts the target of a setpoint elsewhere.
struct Moved {
  Vector2d p_world;
  void operator()(PassTarget& target) const { target.p_world = p_world; }
  void operator()(RestAtTarget& target) const { target.p_world = p_world; }
  void operator()(VelocityCommand&) const {}
  void operator()(ArcCommand&) const {}
};

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

void PositionTrajectory::reset(const VehicleState& state) {
  approach_ = state.heading_world();
  turning_ = false;
  given_ = {};
}

PositionTrajectory::Motion PositionTrajectory::motion_of(const VehicleState& state) const {
  const double h_m = config_.control_point_ahead_m;
  Motion now;
  now.ahead = state.heading_world();
  now.left = left_of(now.ahead);
  now.v_m_s = now.ahead.dot(state.v_world.head<2>());
  now.w_rad_s = state.w_body.z();
  now.p_m = state.p_world.head<2>() + h_m * now.ahead;
  now.velocity_m_s = now.v_m_s * now.ahead + (h_m * now.w_rad_s) * now.left;
  return now;
}

// The target for the control point: as far beyond the axle's as it is ahead of the axle. Nearer
// than that, the direction of the target says nothing any more.
Vector2d PositionTrajectory::beyond(const Vector2d& target_world, const Vector2d& p_world) {
  const Vector2d way = target_world - p_world;
  const double distance_m = way.norm();
  if (distance_m > config_.control_point_ahead_m) approach_ = way / distance_m;
  return target_world + config_.control_point_ahead_m * approach_;
}

bool PositionTrajectory::must_turn(const Motion& now, const Vector2d& towards) {
  const double cosine = now.ahead.dot(towards);
  turning_ = turning_ ? cosine < kTurnedCosine : cosine < 0;
  return turning_;
}

// P'' of the reference error dynamics. Gradient and tangent are orthogonal, so each takes its own
// part: grad.P'' = -2 P'.N P' - T2 psi' - sat(T1 psi), tau.P'' = -T3 (tau.P' - V) - tau'.P'.
Vector2d PositionTrajectory::follow(const PathForm& form, const Motion& now,
                                    double speed_m_s) const {
  const Vector2d gradient = form.gradient(now.p_m);
  const Vector2d tangent = form.tangent(gradient);
  const double square = gradient.squaredNorm();
  const Vector2d bend = form.N * now.velocity_m_s;  // half the gradient's derivative
  const double pull_max = config_.path_damping_1_s * config_.approach_share * speed_m_s;
  const double pull =
      std::clamp(config_.path_stiffness_1_s2 * form.psi_m(now.p_m), -pull_max, pull_max);
  const double across = -2 * now.velocity_m_s.dot(bend) -
                        config_.path_damping_1_s * gradient.dot(now.velocity_m_s) - pull;
  // tau' is across the tangent: along the gradient, turning as the gradient turns.
  const Vector2d tangent_dot = -(2 * tangent.dot(bend) / square) * gradient;
  const double along = -config_.speed_gain_1_s * (tangent.dot(now.velocity_m_s) - speed_m_s) -
                       tangent_dot.dot(now.velocity_m_s);
  return (across / square) * gradient + along * tangent;
}

PositionTrajectory::Rates PositionTrajectory::turn_on_the_spot(const Setpoint& setpoint,
                                                               const Motion& now) const {
  const double a_max = limits_.max_acceleration_m_s2;
  const double turn_max = a_max / config_.control_point_ahead_m;
  // It brakes straight ahead, as its stopping law has it, and turns when it is slow.
  const double w_desired = std::abs(now.v_m_s) > kSlow_m_s
                               ? 0
                               : desired_yaw_rate_rad_s(setpoint, now.ahead, config_.turn_gain_1_s,
                                                        limits_.max_yaw_rate_rad_s);
  return {std::clamp(-config_.point_gain_1_s * now.v_m_s, -a_max, a_max),
          std::clamp(config_.turn_rate_gain_1_s * (w_desired - now.w_rad_s), -turn_max, turn_max)};
}

PositionTrajectory::Rates PositionTrajectory::accelerate(Vector2d acceleration_m_s2,
                                                         const Motion& now) const {
  const double a_max = limits_.max_acceleration_m_s2;
  const double norm = acceleration_m_s2.norm();
  if (norm > a_max) acceleration_m_s2 *= a_max / norm;
  const double h_m = config_.control_point_ahead_m;
  return {acceleration_m_s2.dot(now.ahead) + h_m * now.w_rad_s * now.w_rad_s,
          (acceleration_m_s2.dot(now.left) - now.v_m_s * now.w_rad_s) / h_m};
}

PositionTrajectory::Rates PositionTrajectory::hold(const Vector2d& v_world_m_s, const Motion& now) {
  if (v_world_m_s.norm() > 0 && must_turn(now, v_world_m_s.normalized()))
    return turn_on_the_spot({.heading_world = v_world_m_s.normalized()}, now);
  return accelerate(config_.point_gain_1_s * (v_world_m_s - now.velocity_m_s), now);
}

PositionTrajectory::Rates PositionTrajectory::hold(const ArcCommand& arc, const Motion& now) const {
  const double a_max = limits_.max_acceleration_m_s2;
  const double alpha_max = a_max / config_.control_point_ahead_m;
  return {
      std::clamp(config_.point_gain_1_s * (arc.v_m_s - now.v_m_s), -a_max, a_max),
      std::clamp(config_.turn_rate_gain_1_s * (arc.w_rad_s - now.w_rad_s), -alpha_max, alpha_max)};
}

std::optional<PositionTrajectory::Rates> PositionTrajectory::along(const PathSegment& segment,
                                                                   double speed_m_s,
                                                                   const Motion& now) {
  const PathForm form = PathForm::of(segment);
  const Vector2d gradient = form.gradient(now.p_m);
  if (gradient.norm() <= kNoDirection) return std::nullopt;
  const Vector2d tangent = form.tangent(gradient);
  approach_ = tangent;
  if (must_turn(now, tangent)) return turn_on_the_spot({.heading_world = tangent}, now);
  return accelerate(follow(form, now, std::min(speed_m_s, limits_.max_speed_m_s)), now);
}

PositionTrajectory::Rates PositionTrajectory::wanted(const Setpoint& setpoint,
                                                     const VehicleState& state) {
  const Motion now = motion_of(state);
  if (const auto* command = std::get_if<VelocityCommand>(&setpoint.motion))
    return hold(command->v_world_m_s, now);
  if (const auto* arc = std::get_if<ArcCommand>(&setpoint.motion)) return hold(*arc, now);
  const auto* pass = std::get_if<PassTarget>(&setpoint.motion);
  const auto* rest = std::get_if<RestAtTarget>(&setpoint.motion);
  const double speed_limit_m_s = pass ? pass->speed_limit_m_s : rest->speed_limit_m_s;
  if (speed_limit_m_s <= 0) {
    turning_ = false;
    return turn_on_the_spot(setpoint, now);
  }
  if (pass && pass->segment) {
    if (const auto rates = along(*pass->segment, speed_limit_m_s, now)) return *rates;
  }
  const Vector2d p = state.p_world.head<2>();
  const Vector2d target = pass ? pass->p_world : rest->p_world;
  const Vector2d way = target - p;
  VehicleState at_control_point = state;
  at_control_point.p_world.head<2>() = now.p_m;
  Setpoint moved = setpoint;
  std::visit(Moved{beyond(target, p)}, moved.motion);
  const Vector2d v_desired =
      desired_velocity(moved, at_control_point, profile_, limits_.max_speed_m_s);
  if (way.norm() <= config_.control_point_ahead_m) {
    turning_ = false;
  } else if (must_turn(now, way.normalized())) {
    return turn_on_the_spot({.heading_world = way.normalized()}, now);
  }
  return accelerate(config_.point_gain_1_s * (v_desired - now.velocity_m_s), now);
}

// The motors' torques that give these rates, and the voltages for them at the speeds that the
// wheels will have in the middle of the step in which these voltages act, after the one whose
// voltages are given. At the speeds of now every acceleration would be short by a fifth.
Command PositionTrajectory::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const Rates rates = wanted(setpoint, state);
  const double v = state.heading_world().dot(state.v_world.head<2>());
  const double w = state.w_body.z();
  const double force_N = cart_.mass_kg * rates.v_dot_m_s2 - cart_.offset_kg_m * w * w;
  const double moment_N_m = cart_.inertia_kg_m2 * rates.w_dot_rad_s2 + cart_.offset_kg_m * v * w;
  const double common_N_m = 0.5 * force_N * cart_.wheel_radius_m;
  const double difference_N_m = 0.5 * moment_N_m * cart_.wheel_radius_m / cart_.half_track_m;
  const WheelPair turning =
      cart_.wheel_speeds_rad_s(v + period_s_ * (given_.v_dot_m_s2 + 0.5 * rates.v_dot_m_s2),
                               w + period_s_ * (given_.w_dot_rad_s2 + 0.5 * rates.w_dot_rad_s2));
  given_ = rates;
  double right_V =
      (common_N_m + difference_N_m + cart_.resistance_N_m(turning.right)) / cart_.torque_N_m_V;
  double left_V =
      (common_N_m - difference_N_m + cart_.resistance_N_m(turning.left)) / cart_.torque_N_m_V;
  const double largest_V = std::max(std::abs(right_V), std::abs(left_V));
  if (largest_V > max_voltage_V_) {
    right_V *= max_voltage_V_ / largest_V;
    left_V *= max_voltage_V_ / largest_V;
  }
  return {{right_V, left_V, 0, 0}};
}

StoppingLaw PositionTrajectory::stopping_law() const {
  return {config_.point_gain_1_s, limits_.max_acceleration_m_s2};
}

MotionResponse PositionTrajectory::motion_response() const {
  DriveResponse r;
  r.period_s = period_s_;
  r.speed_gain_1_s = config_.point_gain_1_s;
  r.a_max_m_s2 = limits_.max_acceleration_m_s2;
  r.yaw_rate_gain_1_s = config_.turn_rate_gain_1_s;
  r.alpha_max_rad_s2 = r.a_max_m_s2 / config_.control_point_ahead_m;
  // A wheel turns as fast as its motor at full voltage overcomes friction and its own generator.
  const double wheel_max_rad_s =
      (cart_.torque_N_m_V * max_voltage_V_ - cart_.dry_friction_N_m) / cart_.damping_N_m_s;
  r.limits = {
      .max_speed_m_s = std::min(limits_.max_speed_m_s, cart_.wheel_radius_m * wheel_max_rad_s),
      .max_yaw_rate_rad_s = limits_.max_yaw_rate_rad_s,
      .max_lateral_m_s2 = kLateralShareOfCart * r.a_max_m_s2,
      .half_track_m = cart_.half_track_m,
      .turn_gain_1_s = config_.turn_gain_1_s};
  r.error_at_rest_m = kCartStopErrorAtRest_m;
  r.error_per_speed_s = kCartStopError_s;
  return r;
}

}  // namespace voronaut
