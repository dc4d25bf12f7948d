#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/rotor_allocation.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class Lqr;

struct LqrConfig {
  using Law = Lqr;
  static constexpr const char* kName = "lqr";

  enum class Gains {
    by_inertia,  // corrected or printed, as the vehicle's inertia set says
    corrected,   // 200, 115.2, 17.16
    printed,     // 60, 48.43, 10.29
    custom,      // velocity_gain_1_s3, acceleration_gain_1_s2, jerk_gain_1_s
  };

  Gains gains = Gains::by_inertia;
  double velocity_gain_1_s3 = 200;
  double acceleration_gain_1_s2 = 115.2;
  double jerk_gain_1_s = 17.16;
  SpeedProfileConfig profile;

  template <class Visitor>
  void visit(Visitor& v) {
    v.choice("gains", gains,
             {{"by_inertia", Gains::by_inertia},
              {"corrected", Gains::corrected},
              {"printed", Gains::printed},
              {"custom", Gains::custom}},
             "Gains of the horizontal loops: a set of dynamics/regulators/lqr_gains.py, chosen by "
             "the inertia, or the three below");
    v.number("velocity_gain_1_s3", velocity_gain_1_s3, 0.01, 1e6,
             "Second derivative of the acceleration per error of velocity, for gains: custom");
    v.number("acceleration_gain_1_s2", acceleration_gain_1_s2, 0.01, 1e6,
             "The same per acceleration, for gains: custom");
    v.number("jerk_gain_1_s", jerk_gain_1_s, 0.01, 1e4,
             "The same per derivative of the acceleration, for gains: custom");
    profile.visit(v);
  }
};

// The linear-quadratic regulator of the vehicle at hover, where it falls apart into chains of
// integrators: in the plane velocity v, acceleration a = g tan(tilt), its derivative j, input j';
// height and climb, input the vertical acceleration; heading and yaw rate, input its derivative.
// u = -K x with K of lqr_gains.h, which minimises the integral of x'Qx + r u^2 (Kalman 1960). With
// thrust and torque worked out for the tilt that there is, those chains hold beyond hover, and for
// any mass and inertia: the weights are in units of motion, not of rotors. So
//   j' = k_a (a_d - a) - k_j j,  a_d = (k_v / k_a) (v_d - v) within the tilt limit.
// The gains are those of continuous time; the step that a command comes late they bear, as a test
// holds at 5, 10 and 20 ms.
class Lqr : public Regulator {
 public:
  // `period_s` is the time between two calls.
  Lqr(const LqrConfig& config, const QuadrotorConfig& vehicle, const MotionLimits& limits,
      double period_s);

  void reset(const VehicleState&) override {}
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  VelocityResponse velocity_response() const override;

 private:
  LqrConfig config_;
  QuadrotorConfig vehicle_;
  MotionLimits limits_;
  double period_s_;
  SpeedProfile profile_;
  RotorAllocation allocation_;
  Vec3 inertia_kg_m2_;
  double max_acceleration_m_s2_;
};

}  // namespace voronaut
