#pragma once

#include <optional>

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/regulators/rotor_allocation.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class CascadePid;

struct CascadePidConfig {
  using Law = CascadePid;
  static constexpr const char* kName = "cascade_pid";

  enum class Gains {
    by_inertia,  // corrected or printed, as the vehicle's inertia set says
    corrected,   // 3, 8, 20
    printed,     // 1.5, 4.5, 12
    custom,      // velocity_gain_1_s, attitude_gain_1_s, rate_gain_1_s
  };

  Gains gains = Gains::by_inertia;
  double velocity_gain_1_s = 3;
  double attitude_gain_1_s = 8;
  double rate_gain_1_s = 20;
  double integral_gain_1_s = 0.5;
  double integral_limit_m_s2 = 1;
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
             "Acceleration per error of velocity, for gains: custom");
    v.number("attitude_gain_1_s", attitude_gain_1_s, 0.01, 200,
             "Body rate per error of tilt, for gains: custom");
    v.number("rate_gain_1_s", rate_gain_1_s, 0.01, 500,
             "Angular acceleration per error of body rate, for gains: custom");
    v.number("integral_gain_1_s", integral_gain_1_s, 0, 20,
             "How fast the integral part learns the acceleration that thrust does not explain; "
             "0: none");
    v.number("integral_limit_m_s2", integral_limit_m_s2, 0, 20,
             "Largest acceleration that the integral part makes up for");
    v.number("height_gain_1_s", height_gain_1_s, 0.01, 50, "Climb per error of height");
    v.number("climb_gain_1_s", climb_gain_1_s, 0.01, 50,
             "Vertical acceleration per error of climb");
    v.number("yaw_gain_1_s", yaw_gain_1_s, 0, 50, "Yaw rate per error of heading");
    v.number("yaw_rate_gain_1_s", yaw_rate_gain_1_s, 0, 200,
             "Yaw acceleration per error of yaw rate");
    profile.visit(v);
  }
};

// Position, velocity, attitude and rate, one loop around the other, as flight stacks of
// multicopters have them: the profile turns what is left of the way into a velocity, P and I on
// velocity give an acceleration, within the tilt limit; the thrust axis turns there by the shortest
// way (quaternion P; Brescianini, Hehn, D'Andrea, Nonlinear quadrocopter attitude control, ETH
// 2013, doi 10.3929/ethz-a-009970340), P on the body rates gives torque. In a plane of tilt
//   a'' = rate_gain (attitude_gain (a_d - a) - a'),  a_d = velocity_gain (v_d - v) - d.
//
// d is the integral part, in the form of automatic reset: a low pass, at integral_gain, of the
// acceleration that the thrust does not explain. So it learns wind and drag and not the set-point's
// steps, does not wind up where the tilt limit holds the vehicle back, rests while the limit is
// reached and is never beyond integral_limit. The rate loop has none: nothing in the model holds a
// torque against the rotors.
class CascadePid : public Regulator {
 public:
  // `period_s` is the time between two calls.
  CascadePid(const CascadePidConfig& config, const QuadrotorConfig& vehicle,
             const MotionLimits& limits, double period_s);

  void reset(const VehicleState& state) override;
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  VelocityResponse velocity_response() const override;

 private:
  // Velocity and thrust axis of the call before.
  struct Before {
    Vec3 v_world, axis_world;
  };

  void learn_unexplained(const VehicleState& state, const Vec3& axis_world);

  CascadePidConfig config_;
  QuadrotorConfig vehicle_;
  MotionLimits limits_;
  double period_s_;
  SpeedProfile profile_;
  RotorAllocation allocation_;
  Vec3 inertia_kg_m2_;
  double max_acceleration_m_s2_;
  std::optional<Before> before_;
  bool at_limit_ = false;                 // the acceleration asked for last was cut
  Vec3 unexplained_m_s2_ = Vec3::Zero();  // d
};

}  // namespace voronaut
