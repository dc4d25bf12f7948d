#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/model.h"

namespace voronaut {

class Quadrotor;

// The quadrotor of eqs. (1)-(2) of the quadrotor planner paper (Finaev et al.): plus configuration,
// rotors 1..4 at the body's +x, -y, -x, +y; 1 and 3 turn counter-clockwise seen from above.
struct QuadrotorConfig {
  using Body = Quadrotor;
  static constexpr const char* kName = "quadrotor";

  // The paper prints I_xx = I_yy = 0.081, I_zz = 0.142 kg m^2, which is more than its whole mass at
  // the rotor hubs would have. A tenth of it fits the other parameters and is the default.
  enum class InertiaSet { corrected, printed, custom };

  double mass_kg = 1;
  double arm_m = 0.24;
  double thrust_factor_N_s2 = 53.81e-6;
  double drag_factor_N_m_s2 = 1.1e-6;
  double rotor_inertia_kg_m2 = 73.9e-6;
  InertiaSet inertia = InertiaSet::corrected;
  double inertia_xx_kg_m2 = 0.0081;
  double inertia_yy_kg_m2 = 0.0081;
  double inertia_zz_kg_m2 = 0.0142;
  double min_rotor_speed_rad_s = 64.05;
  double max_rotor_speed_rad_s = 301.92;
  double gravity_m_s2 = 9.81;
  // Not in the paper, off by default.
  double motor_lag_s = 0;
  double linear_drag_1_s = 0;
  bool rotor_acceleration_torque = false;

  Vec3 inertia_kg_m2() const;
  double hover_rotor_speed_rad_s() const;  // sqrt(m g / 4 b)
  // Horizontal, within the limits of acceleration and tilt.
  double max_acceleration_m_s2(const MotionLimits& limits) const;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("mass_kg", mass_kg, 1e-3, 1e3, "Mass of the whole vehicle");
    v.number("arm_m", arm_m, 1e-3, 10, "l: from the centre of mass to a rotor hub");
    v.number("thrust_factor_N_s2", thrust_factor_N_s2, 1e-12, 1,
             "b: thrust of a rotor over its speed squared");
    v.number("drag_factor_N_m_s2", drag_factor_N_m_s2, 0, 1,
             "d: reaction torque of a rotor over its speed squared");
    v.number("rotor_inertia_kg_m2", rotor_inertia_kg_m2, 0, 1, "J_TP: of a rotor about its axis");
    v.choice("inertia", inertia,
             {{"corrected", InertiaSet::corrected},
              {"printed", InertiaSet::printed},
              {"custom", InertiaSet::custom}},
             "Moments of inertia: a tenth of those that the paper prints, as printed, or the three "
             "below");
    v.number("inertia_xx_kg_m2", inertia_xx_kg_m2, 1e-9, 1e3,
             "About the body's x axis, for inertia: custom");
    v.number("inertia_yy_kg_m2", inertia_yy_kg_m2, 1e-9, 1e3,
             "About the body's y axis, for inertia: custom");
    v.number("inertia_zz_kg_m2", inertia_zz_kg_m2, 1e-9, 1e3,
             "About the body's z axis, for inertia: custom");
    v.number("min_rotor_speed_rad_s", min_rotor_speed_rad_s, 0, 1e5,
             "Rotor speeds are clipped from below; the default is 0.3 of hover");
    v.number("max_rotor_speed_rad_s", max_rotor_speed_rad_s, 0, 1e5,
             "Rotor speeds are clipped from above; the default lifts twice the weight");
    v.number("gravity_m_s2", gravity_m_s2, 0, 100, "Acceleration of free fall");
    v.number("motor_lag_s", motor_lag_s, 0, 10,
             "Time constant of a rotor's speed, not in the paper; 0: it follows at once");
    v.number("linear_drag_1_s", linear_drag_1_s, 0, 100,
             "Deceleration by air per speed, not in the paper");
    v.flag("rotor_acceleration_torque", rotor_acceleration_torque,
           "Accelerating rotors turn the body, not in the paper; needs motor_lag_s");
  }
};

// Coefficients of eqs. (1)-(2) for one vehicle; those per squared rotor speed are accelerations.
struct RigidBodyCoefficients {
  double gravity_m_s2, drag_1_s;
  double thrust, roll, pitch, yaw;            // b/m, b l/I_xx, b l/I_yy, d/I_zz
  double gyro_p, gyro_q, reaction;            // J_TP/I_xx, J_TP/I_yy, J_TP/I_zz or 0
  double coupling_p, coupling_q, coupling_r;  // (I_yy - I_zz)/I_xx and so on
};

// Rigid body with a quaternion state, one RK4 step per period, rotor speeds held over it; the
// quaternion is renormalised once per step. Command: rotor speeds [rad/s], clipped to the limits.
// VehicleState::actuators are the rotor speeds at the end of the step.
//
// Omega, the rotors' residual speed in eq. (1), is W1 - W2 + W3 - W4: the only sign with which eqs.
// (1) and (2) together conserve angular momentum.
class Quadrotor : public Model {
 public:
  // Throws std::invalid_argument if the rotors cannot hold the vehicle in the air.
  explicit Quadrotor(const QuadrotorConfig& config = {});

  Mobility mobility() const override { return {}; }
  VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const override;
  Command hold() const override;
  VehicleState step(const VehicleState& state, const Command& command,
                    double period_s) const override;
  // Of the rotors against the air: the reaction torque d W^2 of eq. (2) times the speed W, summed;
  // 42.8 W at hover. What spins them up comes back when they slow down and is not counted.
  double power_w(const VehicleState& state) const override;

 private:
  QuadrotorConfig config_;
  RigidBodyCoefficients body_;
  double hover_rad_s_;
};

}  // namespace voronaut
