#pragma once

#include "voronaut/dynamics/arc_steering.h"
#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/unicycle.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class ArcTracker;

struct ArcTrackerConfig {
  using Law = ArcTracker;
  static constexpr const char* kName = "arc_tracker";

  double speed_gain_1_s = 8;
  double yaw_rate_gain_1_s = 10;
  double turn_gain_1_s = 2.5;
  SpeedProfileConfig profile = {.goal_gain_1_s = 0.8};

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("speed_gain_1_s", speed_gain_1_s, 0.01, 50,
             "Acceleration per error of speed; no more than a quarter of the steps per second");
    v.number("yaw_rate_gain_1_s", yaw_rate_gain_1_s, 0.01, 50,
             "Angular acceleration per error of yaw rate; no more than that either");
    v.number("turn_gain_1_s", turn_gain_1_s, 0.01, 50,
             "On the spot: yaw rate per error of heading");
    profile.visit(v);
  }
};

// For the unicycle. What it wants is an arc, speed v_d and yaw rate w_d:
// - an arc commanded is held as it is;
// - a target is driven to by pure pursuit (arc_steering.h), after a turn on the spot if it does not
//   lie ahead; where it shall rest it slows down by the profile;
// - told to stand (speed limit 0), it turns on the spot to the setpoint's heading.
// Speed and yaw rate approach it by dv/dt = clip(k_v (v_d - v), a), dw/dt = clip(k_w (w_d - w),
// alpha): the loop of drive_response.h. The lag of the drive is undone. Height is not its business.
// Assumes that what it returns is applied one step later.
class ArcTracker : public Regulator {
 public:
  // `period_s` is the time between two calls.
  ArcTracker(const ArcTrackerConfig& config, const UnicycleConfig& vehicle,
             const MotionLimits& limits, double period_s);

  void reset(const VehicleState& state) override;
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  MotionResponse motion_response() const override { return response_; }

 private:
  ArcCommand wanted(const Setpoint& setpoint, const VehicleState& state) const;
  ArcCommand rest_at(const RestAtTarget& target, const DriveMotion& now) const;

  DriveResponse response_;
  double undo_lag_s_;  // ask for so much more of a rate that the drive has it within one step
  SpeedProfile profile_;
  double v_dot_given_m_s2_ = 0;  // by the command before, which acts now
  double w_dot_given_rad_s2_ = 0;
};

}  // namespace voronaut
