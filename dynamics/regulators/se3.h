#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/rotor_allocation.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class Se3;

struct Se3Config {
  using Law = Se3;
  static constexpr const char* kName = "se3";

  enum class Gains {
    by_inertia,  // corrected or printed, as the vehicle's inertia set says
    corrected,   // 2, 10, 0.9
    printed,     // 1.6, 7, 0.9
    custom,      // velocity_gain_1_s, attitude_pole_rad_s, attitude_damping
  };

  Gains gains = Gains::by_inertia;
  double velocity_gain_1_s = 2;
  double attitude_pole_rad_s = 10;
  double attitude_damping = 0.9;
  double height_gain_1_s = 1.667;
  double climb_gain_1_s = 5.4;
  double yaw_gain_1_s = 0.833;
  double yaw_rate_gain_1_s = 2.7;
  SpeedProfileConfig profile;

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("gains", gains,
             {{"by_inertia", Gains::by_inertia},
              {"corrected", Gains::corrected},
              {"printed", Gains::printed},
              {"custom", Gains::custom}},
             "Gains of the horizontal loops: a set, chosen by the inertia, or the three below");
    v.number("velocity_gain_1_s", velocity_gain_1_s, 0.01, 50,
             "k_v / m: acceleration per error of velocity, for gains: custom");
    v.number("attitude_pole_rad_s", attitude_pole_rad_s, 0.01, 1000,
             "k_R / J is its square: natural frequency of the attitude, for gains: custom");
    v.number("attitude_damping", attitude_damping, 0.05, 10,
             "k_W / J is twice this times the pole, for gains: custom");
    v.number("height_gain_1_s", height_gain_1_s, 0.01, 50, "Climb per error of height");
    v.number("climb_gain_1_s", climb_gain_1_s, 0.01, 50,
             "Vertical acceleration per error of climb");
    v.number("yaw_gain_1_s", yaw_gain_1_s, 0, 50, "Yaw rate per error of heading");
    v.number("yaw_rate_gain_1_s", yaw_rate_gain_1_s, 0, 200,
             "Yaw acceleration per error of yaw rate");
    profile.visit(v);
  }
};

// The geometric tracking control of T. Lee, M. Leok, N. H. McClamroch, Geometric tracking control
// of a quadrotor UAV on SE(3), CDC 2010, doi 10.1109/CDC.2010.5717652. Their z axes point down;
// with ours up, thrust along +z of the body:
//   F   = m (a_d + g e3),  a_d = -(k_x/m) e_x - (k_v/m) e_v + x_d''
//   f   = F . R e3
//   b3d = F / |F|,  b2d = b3d x b1d / |b3d x b1d|,  Rd = [b2d x b3d, b2d, b3d]
//   e_R = (Rd' R - R' Rd)^vee / 2,  e_W = W - R' Rd Wd
//   M   = -k_R e_R - k_W e_W + W x J W - J (W x R' Rd Wd)
// almost globally exponentially attractive for attitudes that start less than 180 deg off.
//
// What is this project's:
// - e_x enters through the velocity asked for, (k_x/m) e_x = (k_v/m) v(e_x) with v of the profile,
//   which bounds speed; a_d is cut at the tilt limit; x_d'' is 0, setpoints stand or jump.
// - b1d is the heading that there is, and the heading's error is in the yaw rate r_d asked for, so
//   that it keeps its limit. r_d is about the body's own axis, R' Rd Wd = (0, 0, r_d), with what
//   keeps the tilt straight meanwhile (thrust_vectoring.h) in place of the last term of M. About
//   b3d, as printed, the thrust circles it while the body yaws, and stops stray 2 to 4 times as far
//   from their prediction. Without yaw both are the printed law.
class Se3 : public Regulator {
 public:
  // `period_s` is the time between two calls.
  Se3(const Se3Config& config, const QuadrotorConfig& vehicle, const MotionLimits& limits,
      double period_s);

  void reset(const VehicleState&) override {}
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  VelocityResponse velocity_response() const override;

 private:
  Vec3 force_per_mass(const Setpoint& setpoint, const VehicleState& state) const;

  Se3Config config_;
  QuadrotorConfig vehicle_;
  MotionLimits limits_;
  double period_s_;
  SpeedProfile profile_;
  RotorAllocation allocation_;
  Vec3 inertia_kg_m2_;
  double max_acceleration_m_s2_;
};

}  // namespace voronaut
