#include "voronaut/dynamics/regulators/pd_rate.h"

#include <algorithm>
#include <cmath>

#include "voronaut/dynamics/regulators/guidance.h"

namespace voronaut {
namespace {

using Eigen::Vector2d;
using Poles = PdRateConfig::Poles;

constexpr double kHeightReserve = 0.1;  // of hover speed, kept from the limits for tilt
constexpr double kYawAuthority = 0.15;  // of hover speed
constexpr double kMinCosTilt = 0.25;    // the thrust is not raised for more tilt than that

// Bounds of VelocityResponse::error_m that tests/dynamics/velocity_response_test.cpp holds.
constexpr double kPdRateStopErrorAtRest_m = 0.014;
constexpr double kAgileStopError_s = 0.008;    // on the corrected inertia
constexpr double kSluggishStopError_s = 0.13;  // on the printed one the rotors saturate

struct HorizontalPoles {
  double velocity_rad_s, attitude_rad_s, damping;
};

HorizontalPoles horizontal_poles(const PdRateConfig& config, const QuadrotorConfig& vehicle) {
  Poles poles = config.poles;
  if (poles == Poles::by_inertia) {
    poles =
        vehicle.inertia == QuadrotorConfig::InertiaSet::printed ? Poles::printed : Poles::corrected;
  }
  switch (poles) {
    case Poles::printed:
      return {2.5, 8, 0.9};
    case Poles::printed_soft:
      return {2, 6, 0.9};
    case Poles::custom:
      return {config.velocity_pole_rad_s, config.attitude_pole_rad_s, config.attitude_damping};
    case Poles::by_inertia:
    case Poles::corrected:
      break;
  }
  return {2.5, 10, 0.8};
}

// Third row and column of the rotation matrix are all that the law needs of the attitude.
struct Tilt {
  double r13, r23, r33;
};

Tilt tilt_of(const Eigen::Quaterniond& q) {
  return {2 * (q.x() * q.z() + q.w() * q.y()), 2 * (q.y() * q.z() - q.w() * q.x()),
          1 - 2 * (q.x() * q.x() + q.y() * q.y())};
}

}  // namespace

PdRateGains place_poles(const PdRateConfig& config, const QuadrotorConfig& vehicle) {
  const HorizontalPoles p = horizontal_poles(config, vehicle);
  const Vec3 inertia = vehicle.inertia_kg_m2();
  const double hover_rad_s = vehicle.hover_rotor_speed_rad_s();
  const double g = vehicle.gravity_m_s2;
  // Angular, vertical and yaw acceleration per rad/s of demand, at hover.
  const double kappa = 2 * vehicle.thrust_factor_N_s2 * vehicle.arm_m * hover_rad_s / inertia.x();
  const double lift = 2 * g / hover_rad_s;
  const double turn = 8 * vehicle.drag_factor_N_m_s2 * hover_rad_s / inertia.z();
  const double wa2 = p.attitude_rad_s * p.attitude_rad_s;
  const double twice_damped = 2 * p.damping * p.attitude_rad_s;
  return {.kp = p.velocity_rad_s * wa2 / (g * kappa),
          .kd = (wa2 + twice_damped * p.velocity_rad_s) / (g * kappa),
          .kq = (p.velocity_rad_s + twice_damped) / kappa,
          .gyro_s = inertia.z() / (inertia.x() * kappa),
          .height_kp = config.height_pole_rad_s * config.height_pole_rad_s / lift,
          .height_kd = 2 * config.height_damping * config.height_pole_rad_s / lift,
          .yaw_k = config.yaw_pole_rad_s * config.yaw_pole_rad_s / turn,
          .yaw_kr = 2 * config.yaw_damping * config.yaw_pole_rad_s / turn};
}

PdRate::PdRate(const PdRateConfig& config, const QuadrotorConfig& vehicle,
               const MotionLimits& limits, double period_s)
    : config_(config),
      vehicle_(vehicle),
      limits_(limits),
      period_s_(period_s),
      gains_(place_poles(config, vehicle)),
      profile_(config.profile),
      hover_rad_s_(vehicle.hover_rotor_speed_rad_s()),
      max_acceleration_m_s2_(vehicle.max_acceleration_m_s2(limits)) {}

void PdRate::reset(const VehicleState& state) { previous_v_world_ = state.v_world.head<2>(); }

// This and saturate() are inline for the sake of a shared library, where the compiler may not make
// them so by itself: they are called once in every vehicle step.
inline Vector2d PdRate::acceleration_world(const VehicleState& state) const {
  if (config_.acceleration == PdRateConfig::Acceleration::attitude) {
    const Tilt tilt = tilt_of(state.q_world_body);
    const double per_cos = vehicle_.gravity_m_s2 / std::max(tilt.r33, kMinCosTilt);
    return {tilt.r13 * per_cos, tilt.r23 * per_cos};
  }
  return (state.v_world.head<2>() - previous_v_world_) / period_s_;
}

inline void PdRate::saturate(RotorDemand& demand) const {
  const double reserve = kHeightReserve * hover_rad_s_;
  demand.collective = std::clamp(demand.collective, vehicle_.min_rotor_speed_rad_s + reserve,
                                 vehicle_.max_rotor_speed_rad_s - reserve);
  const double room = std::min(vehicle_.max_rotor_speed_rad_s - demand.collective,
                               demand.collective - vehicle_.min_rotor_speed_rad_s);
  demand.forward = std::clamp(demand.forward, -2 * room, 2 * room);
  demand.right = std::clamp(demand.right, -2 * room, 2 * room);
  const double used = 0.5 * std::max(std::abs(demand.forward), std::abs(demand.right));
  const double yaw_room = std::min(kYawAuthority * hover_rad_s_, room - used);
  demand.yaw = std::clamp(demand.yaw, -yaw_room, yaw_room);
  // Thrust grows with the square of speed: the pair that yaw slows down turns the vehicle less for
  // the same difference, the other one more.
  demand.forward *= demand.collective / (demand.collective - demand.yaw);
  demand.right *= demand.collective / (demand.collective + demand.yaw);
}

Command PdRate::regulate(const Setpoint& setpoint, const VehicleState& state) {
  const Vector2d v_world = state.v_world.head<2>();
  const Vector2d v_desired = desired_velocity(setpoint, state, profile_, limits_.max_speed_m_s);

  // Acceleration asked for, within the tilt limit.
  Vector2d a_desired = gains_.velocity_gain_1_s() * (v_desired - v_world);
  const double a_norm = a_desired.norm();
  if (a_norm > max_acceleration_m_s2_) a_desired *= max_acceleration_m_s2_ / a_norm;
  const Vector2d push = gains_.kd * (a_desired - acceleration_world(state));
  previous_v_world_ = v_world;

  const Vector2d ahead = state.heading_world();
  const double p = state.w_body.x();
  const double q = state.w_body.y();
  const double r = state.w_body.z();
  const double cos_tilt = std::max(tilt_of(state.q_world_body).r33, kMinCosTilt);
  const double climb_error =
      desired_climb_m_s(setpoint, state, gains_.height_kp / gains_.height_kd) - state.v_world.z();
  const double yaw_rate = desired_yaw_rate_rad_s(setpoint, ahead, gains_.yaw_k / gains_.yaw_kr,
                                                 limits_.max_yaw_rate_rad_s);

  RotorDemand demand;
  demand.collective = (hover_rad_s_ + gains_.height_kd * climb_error) / std::sqrt(cos_tilt);
  demand.forward = push.dot(ahead) - gains_.kq * q - gains_.gyro_s * p * r;
  demand.right =
      push.x() * ahead.y() - push.y() * ahead.x() - gains_.kq * p + gains_.gyro_s * q * r;
  demand.yaw = gains_.yaw_kr * (yaw_rate - r);
  saturate(demand);
  return mixed(demand);
}

StoppingLaw PdRate::stopping_law() const {
  return {gains_.velocity_gain_1_s(), max_acceleration_m_s2_};
}

VelocityResponse PdRate::velocity_response() const {
  const StoppingLaw law = stopping_law();
  const double kappa = 2 * vehicle_.thrust_factor_N_s2 * vehicle_.arm_m * hover_rad_s_ /
                       vehicle_.inertia_kg_m2().x();
  const double room_rad_s = std::min(vehicle_.max_rotor_speed_rad_s - hover_rad_s_,
                                     hover_rad_s_ - vehicle_.min_rotor_speed_rad_s);
  VelocityResponse response;
  response.period_s = period_s_;
  response.k_1_s = law.k_1_s;
  response.a_max_m_s2 = law.a_m_s2;
  response.gravity_m_s2 = vehicle_.gravity_m_s2;
  response.gain_1_s2 = vehicle_.gravity_m_s2 * kappa * gains_.kd;
  response.damping_1_s = kappa * gains_.kq;
  response.push_max_m_s4 = vehicle_.gravity_m_s2 * kappa * 2 * room_rad_s;
  // Tilted, a turn of the thrust changes its horizontal part by 1/cos^2, and the rotors turn faster
  // by 1/sqrt(cos).
  response.push_growth = 1.25;
  // The latest difference of velocities is half a step old.
  if (config_.acceleration == PdRateConfig::Acceleration::velocity_difference)
    response.acceleration_age_s = 0.5 * period_s_;
  response.error_at_rest_m = kPdRateStopErrorAtRest_m;
  response.error_per_speed_s = vehicle_.inertia == QuadrotorConfig::InertiaSet::corrected
                                   ? kAgileStopError_s
                                   : kSluggishStopError_s;
  return response;
}

}  // namespace voronaut
