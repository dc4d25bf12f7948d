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
  double thrust_factor_N_s2 = 53.81e-6;  // b: thrust of a rotor over its speed squared
  double drag_factor_N_m_s2 = 1.1e-6;    // d: its reaction torque
  double rotor_inertia_kg_m2 = 73.9e-6;  // J_TP, about the rotor's axis
  InertiaSet inertia = InertiaSet::corrected;
  double inertia_xx_kg_m2 = 0.0081;  // these three for InertiaSet::custom only
  double inertia_yy_kg_m2 = 0.0081;
  double inertia_zz_kg_m2 = 0.0142;
  double min_rotor_speed_rad_s = 64.05;   // 0.3 of hover
  double max_rotor_speed_rad_s = 301.92;  // twice the weight
  double gravity_m_s2 = 9.81;
  // Not in the paper, off by default.
  double motor_lag_s = 0;                  // time constant of a rotor's speed; 0: follows at once
  double linear_drag_1_s = 0;              // deceleration by air per speed
  bool rotor_acceleration_torque = false;  // yaw reaction to accelerating rotors; needs motor_lag_s

  Vec3 inertia_kg_m2() const;
  double hover_rotor_speed_rad_s() const;  // sqrt(m g / 4 b)
  // Horizontal, within the limits of acceleration and tilt.
  double max_acceleration_m_s2(const MotionLimits& limits) const;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("mass_kg", mass_kg, 1e-3, 1e3);
    v.number("arm_m", arm_m, 1e-3, 10);
    v.number("thrust_factor_N_s2", thrust_factor_N_s2, 1e-12, 1);
    v.number("drag_factor_N_m_s2", drag_factor_N_m_s2, 0, 1);
    v.number("rotor_inertia_kg_m2", rotor_inertia_kg_m2, 0, 1);
    v.choice("inertia", inertia,
             {{"corrected", InertiaSet::corrected},
              {"printed", InertiaSet::printed},
              {"custom", InertiaSet::custom}});
    v.number("inertia_xx_kg_m2", inertia_xx_kg_m2, 1e-9, 1e3);
    v.number("inertia_yy_kg_m2", inertia_yy_kg_m2, 1e-9, 1e3);
    v.number("inertia_zz_kg_m2", inertia_zz_kg_m2, 1e-9, 1e3);
    v.number("min_rotor_speed_rad_s", min_rotor_speed_rad_s, 0, 1e5);
    v.number("max_rotor_speed_rad_s", max_rotor_speed_rad_s, 0, 1e5);
    v.number("gravity_m_s2", gravity_m_s2, 0, 100);
    v.number("motor_lag_s", motor_lag_s, 0, 10);
    v.number("linear_drag_1_s", linear_drag_1_s, 0, 100);
    v.flag("rotor_acceleration_torque", rotor_acceleration_torque);
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

 private:
  QuadrotorConfig config_;
  RigidBodyCoefficients body_;
  double hover_rad_s_;
};

}  // namespace voronaut
