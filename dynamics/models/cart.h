#pragma once

#include "voronaut/dynamics/model.h"

namespace voronaut {

class Cart;

// A cart on two driven wheels with DC motors and a castor without mass: the vehicle of the cart
// planner paper (Soloviev et al.), which leaves its model to Budanov and Deyanin 2003. Their text
// was not at hand: these are the textbook equations of that vehicle (docs/equations.md), the
// numbers those of a small research robot.
struct CartConfig {
  using Body = Cart;
  static constexpr const char* kName = "cart";

  double body_mass_kg = 9;
  double wheel_mass_kg = 0.4;
  double wheel_radius_m = 0.0975;
  double half_track_m = 0.165;
  double center_of_mass_ahead_m = 0.03;
  double body_inertia_kg_m2 = 0.10;
  double wheel_inertia_kg_m2 = 0.0019;
  double wheel_yaw_inertia_kg_m2 = 0.001;
  double gear_ratio = 38.3;
  double gear_efficiency = 0.8;
  double torque_constant_N_m_A = 0.023;
  double back_emf_V_s = 0.023;
  double armature_resistance_ohm = 0.71;
  double motor_inertia_kg_m2 = 7e-6;
  double motor_friction_N_m_s = 1e-5;
  double dry_friction_N_m = 0.35;
  double max_voltage_V = 12;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("body_mass_kg", body_mass_kg, 1e-3, 1e4, "Mass without the wheels");
    v.number("wheel_mass_kg", wheel_mass_kg, 0, 1e3, "Mass of one wheel");
    v.number("wheel_radius_m", wheel_radius_m, 1e-3, 10, "Radius of a driven wheel");
    v.number("half_track_m", half_track_m, 1e-3, 10, "B: from the middle of the axle to a wheel");
    v.number("center_of_mass_ahead_m", center_of_mass_ahead_m, -10, 10,
             "d: of the body, ahead of the middle of the axle");
    v.number("body_inertia_kg_m2", body_inertia_kg_m2, 1e-9, 1e5,
             "I_b: of the body about its centre of mass, vertical axis");
    v.number("wheel_inertia_kg_m2", wheel_inertia_kg_m2, 0, 1e3, "J_w: of a wheel about the axle");
    v.number("wheel_yaw_inertia_kg_m2", wheel_yaw_inertia_kg_m2, 0, 1e3,
             "I_m: of a wheel about its vertical");
    v.number("gear_ratio", gear_ratio, 0.01, 1e4, "N: turns of the motor per turn of the wheel");
    v.number("gear_efficiency", gear_efficiency, 0.01, 1,
             "eta: share of the torque that the gear passes on");
    v.number("torque_constant_N_m_A", torque_constant_N_m_A, 1e-6, 100,
             "kt: torque of a motor per current");
    v.number("back_emf_V_s", back_emf_V_s, 0, 100,
             "ke: voltage that a motor induces per angular speed");
    v.number("armature_resistance_ohm", armature_resistance_ohm, 1e-6, 1e6, "Ra: of a motor");
    v.number("motor_inertia_kg_m2", motor_inertia_kg_m2, 0, 1e3, "J_m: of a rotor about its axis");
    v.number("motor_friction_N_m_s", motor_friction_N_m_s, 0, 100,
             "fv: viscous friction at the motor");
    v.number("dry_friction_N_m", dry_friction_N_m, 0, 1e3,
             "f_r: at a wheel, fades below 0.2 rad/s");
    v.number("max_voltage_V", max_voltage_V, 0.1, 1e4, "Motor voltages are clipped to it");
  }
};

// Of the wheels' motion, in the order of VehicleState::actuators and Command: right, left.
struct WheelPair {
  double right = 0;
  double left = 0;
};

// What the equations of a cart are made of:
//   M v' = (tR + tL)/r + m_b d w^2,   J w' = (B/r)(tR - tL) - m_b d v w,
//   t = Ku u - Kv O - f_r tanh(O / 0.2 rad/s),   O_R,L = (v +- B w)/r.
struct CartCoefficients {
  explicit CartCoefficients(const CartConfig& config);

  WheelPair wheel_speeds_rad_s(double speed_m_s, double yaw_rate_rad_s) const;
  // What a motor at no voltage takes from a wheel that turns.
  double resistance_N_m(double wheel_speed_rad_s) const;

  double mass_kg;        // M: with what the wheels and motors add
  double inertia_kg_m2;  // J: likewise, about the middle of the axle
  double offset_kg_m;    // m_b d
  double wheel_radius_m, half_track_m;
  double torque_N_m_V;      // Ku
  double damping_N_m_s;     // Kv
  double dry_friction_N_m;  // f_r
};

// Rolls without slip on level ground: VehicleState::p_world is the middle of the axle, its height
// never changes, velocity is along the heading. Four RK4 steps per period, for dry friction is
// stiff. Command: voltages of the right and the left motor, each clipped to the limit; the other
// two numbers are not used. VehicleState::actuators are the speeds of the right and left wheel.
class Cart : public Model {
 public:
  explicit Cart(const CartConfig& config = {})
      : coefficients_(config), max_voltage_V_(config.max_voltage_V) {}

  Mobility mobility() const override { return {.flies = false, .moves_sideways = false}; }
  VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const override;
  Command hold() const override { return {}; }
  VehicleState step(const VehicleState& state, const Command& command,
                    double period_s) const override;

 private:
  CartCoefficients coefficients_;
  double max_voltage_V_;
};

}  // namespace voronaut
