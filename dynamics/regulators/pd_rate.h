#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/rotor_mixing.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

struct PdRateConfig {
  // Closed-loop poles (s + wv)(s^2 + 2 zeta wa s + wa^2) of the horizontal loops.
  enum class Poles {
    by_inertia,    // corrected or printed, as the vehicle's inertia set says
    corrected,     // 2.5, 10, 0.8
    printed,       // 2.5, 8, 0.9
    printed_soft,  // 2, 6, 0.9
    custom,        // velocity_pole_rad_s, attitude_pole_rad_s, attitude_damping
  };
  // Where the acceleration of the D term comes from.
  enum class Acceleration {
    velocity_difference,  // as eq. (4): (V(i) - V(i-1)) / T; amplifies noise on V
    attitude,             // g tan of the tilt: the same linear loop, quiet
  };

  Poles poles = Poles::by_inertia;
  double velocity_pole_rad_s = 2.5;
  double attitude_pole_rad_s = 10;
  double attitude_damping = 0.8;
  double height_pole_rad_s = 3;
  double height_damping = 0.9;
  double yaw_pole_rad_s = 1.5;
  double yaw_damping = 0.9;
  Acceleration acceleration = Acceleration::velocity_difference;
  SpeedProfileConfig profile;

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("poles", poles,
             {{"by_inertia", Poles::by_inertia},
              {"corrected", Poles::corrected},
              {"printed", Poles::printed},
              {"printed_soft", Poles::printed_soft},
              {"custom", Poles::custom}});
    v.number("velocity_pole_rad_s", velocity_pole_rad_s, 0.01, 1000);
    v.number("attitude_pole_rad_s", attitude_pole_rad_s, 0.01, 1000);
    v.number("attitude_damping", attitude_damping, 0.05, 10);
    v.number("height_pole_rad_s", height_pole_rad_s, 0.01, 1000);
    v.number("height_damping", height_damping, 0.05, 10);
    v.number("yaw_pole_rad_s", yaw_pole_rad_s, 0.01, 1000);
    v.number("yaw_damping", yaw_damping, 0.05, 10);
    v.choice("acceleration", acceleration,
             {{"velocity_difference", Acceleration::velocity_difference},
              {"attitude", Acceleration::attitude}});
    profile.visit(v);
  }
};

// Gains in rad/s of rotor speed per unit of what they multiply.
struct PdRateGains {
  double kp, kd, kq;            // velocity, acceleration, body rate
  double gyro_s;                // tilt rate times yaw rate
  double height_kp, height_kd;  // height, climb
  double yaw_k, yaw_kr;         // heading, yaw rate

  double velocity_gain_1_s() const { return kp / kd; }  // k of the stopping distance
};

// Gains that put the linearised loops' poles where the config says, from the vehicle's inertia.
PdRateGains place_poles(const PdRateConfig& config, const QuadrotorConfig& vehicle);

// The paper's regulator, eqs. (3)-(6), with the one term per axis that makes it stable: the literal
// law's characteristic polynomial s^3 + K kd s + K kp has no s^2 term, so its roots sum to zero and
// no gains stabilise it. A rate gyro adds it: s^3 + kappa kq s^2 + K kd s + K kp, stable if and
// only if kp < kappa kq kd (Routh). Besides: tilt limit, height and yaw loops, saturation with
// priority height > tilt > yaw. Assumes that what it returns is applied one step later.
//
// Turning does not bend the flight. In body axes a tilt rate (p, q) that is straight in the world
// turns by r (q, -p); of eq. (1) the vehicle itself does (Ixx - Izz) / Ixx of that, so the
// regulator adds Izz / Ixx r (q, -p), gyro_s in rotor speed. Without both this and the undoing of
// the yaw demand in saturate(), stops strayed up to 2.5 times as far from their prediction.
class PdRate : public Regulator {
 public:
  // `period_s` is the time between two calls.
  PdRate(const PdRateConfig& config, const QuadrotorConfig& vehicle, const MotionLimits& limits,
         double period_s);

  void reset(const VehicleState& state) override;
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;

 private:
  Eigen::Vector2d acceleration_world(const VehicleState& state) const;
  void saturate(RotorDemand& demand) const;

  PdRateConfig config_;
  QuadrotorConfig vehicle_;
  MotionLimits limits_;
  double period_s_;
  PdRateGains gains_;
  SpeedProfile profile_;
  double hover_rad_s_;
  double max_acceleration_m_s2_;
  Eigen::Vector2d previous_v_world_ = Eigen::Vector2d::Zero();
};

}  // namespace voronaut
