#include "voronaut/dynamics/models/cart.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

#include "voronaut/dynamics/attitude.h"
#include "voronaut/dynamics/integrate.h"

namespace voronaut {
namespace {

constexpr int kSubsteps = 4;
// Dry friction is three quarters of itself at this speed of a wheel.
constexpr double kFrictionFades_rad_s = 0.2;

double squared(double x) { return x * x; }

// Of a wheel and its motor about the axle.
double geared_inertia_kg_m2(const CartConfig& c) {
  return c.wheel_inertia_kg_m2 + squared(c.gear_ratio) * c.motor_inertia_kg_m2;
}

// x, y, cosine and sine of the heading, speed, yaw rate.
using Rolling = std::array<double, 6>;

}  // namespace

CartCoefficients::CartCoefficients(const CartConfig& c)
    : mass_kg(c.body_mass_kg + 2 * c.wheel_mass_kg +
              2 * geared_inertia_kg_m2(c) / squared(c.wheel_radius_m)),
      inertia_kg_m2(c.body_inertia_kg_m2 + c.body_mass_kg * squared(c.center_of_mass_ahead_m) +
                    2 * c.wheel_mass_kg * squared(c.half_track_m) + 2 * c.wheel_yaw_inertia_kg_m2 +
                    2 * geared_inertia_kg_m2(c) * squared(c.half_track_m) /
                        squared(c.wheel_radius_m)),
      offset_kg_m(c.body_mass_kg * c.center_of_mass_ahead_m),
      wheel_radius_m(c.wheel_radius_m),
      half_track_m(c.half_track_m),
      torque_N_m_V(c.gear_efficiency * c.gear_ratio * c.torque_constant_N_m_A /
                   c.armature_resistance_ohm),
      damping_N_m_s(squared(c.gear_ratio) * (c.gear_efficiency * c.torque_constant_N_m_A *
                                                 c.back_emf_V_s / c.armature_resistance_ohm +
                                             c.motor_friction_N_m_s)),
      dry_friction_N_m(c.dry_friction_N_m) {}

WheelPair CartCoefficients::wheel_speeds_rad_s(double speed_m_s, double yaw_rate_rad_s) const {
  const double difference_m_s = half_track_m * yaw_rate_rad_s;
  return {(speed_m_s + difference_m_s) / wheel_radius_m,
          (speed_m_s - difference_m_s) / wheel_radius_m};
}

double CartCoefficients::resistance_N_m(double wheel_speed_rad_s) const {
  return damping_N_m_s * wheel_speed_rad_s +
         dry_friction_N_m * Sleef_cinz_tanhd1_u10purec(wheel_speed_rad_s / kFrictionFades_rad_s);
}

VehicleState Cart::at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const {
  VehicleState state;
  state.p_world = p_world;
  state.q_world_body = level_attitude(heading_world);
  return state;
}

VehicleState Cart::step(const VehicleState& state, const Command& command, double period_s) const {
  const CartCoefficients& k = coefficients_;
  const auto voltage_V = [&](std::size_t i) {
    return std::clamp(command.u[i], -max_voltage_V_, max_voltage_V_);
  };
  const WheelPair drive_N_m{k.torque_N_m_V * voltage_V(0), k.torque_N_m_V * voltage_V(1)};
  const auto derivative = [&](const Rolling& x) -> Rolling {
    const double cosine = x[2], sine = x[3], v = x[4], w = x[5];
    const WheelPair turning = k.wheel_speeds_rad_s(v, w);
    const double right_N = (drive_N_m.right - k.resistance_N_m(turning.right)) / k.wheel_radius_m;
    const double left_N = (drive_N_m.left - k.resistance_N_m(turning.left)) / k.wheel_radius_m;
    return {v * cosine,
            v * sine,
            -w * sine,
            w * cosine,
            (right_N + left_N + k.offset_kg_m * w * w) / k.mass_kg,
            (k.half_track_m * (right_N - left_N) - k.offset_kg_m * v * w) / k.inertia_kg_m2};
  };

  const Eigen::Vector2d ahead = state.heading_world();
  Rolling x{state.p_world.x(),
            state.p_world.y(),
            ahead.x(),
            ahead.y(),
            ahead.dot(state.v_world.head<2>()),
            state.w_body.z()};
  for (int i = 0; i < kSubsteps; ++i) x = rk4_step(x, period_s / kSubsteps, derivative);

  const Eigen::Vector2d heading = Eigen::Vector2d(x[2], x[3]).normalized();
  const WheelPair turning = k.wheel_speeds_rad_s(x[4], x[5]);
  VehicleState next;
  next.p_world = {x[0], x[1], state.p_world.z()};
  next.v_world = {x[4] * heading.x(), x[4] * heading.y(), 0};
  next.q_world_body = level_attitude(heading);
  next.w_body = {0, 0, x[5]};
  next.actuators = {turning.right, turning.left, 0, 0};
  return next;
}

}  // namespace voronaut
