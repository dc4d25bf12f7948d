#pragma once

#include "voronaut/dynamics/car_response.h"
#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/car.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class CarTracker;

struct CarTrackerConfig {
  using Law = CarTracker;
  static constexpr const char* kName = "car_tracker";

  double speed_gain_1_s = 8;
  double steering_gain_1_s = 10;
  SpeedProfileConfig profile = {.goal_gain_1_s = 0.8};

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("speed_gain_1_s", speed_gain_1_s, 0.01, 50,
             "Acceleration per error of speed; no more than a quarter of the steps per second");
    v.number("steering_gain_1_s", steering_gain_1_s, 0.01, 50,
             "Steering rate per error of the steering angle; no more than that either");
    profile.visit(v);
  }
};

// For the car. An arc commanded is held; a target is driven to by pure pursuit as tightly as the
// steering allows, forwards only (what lies within the turning circle is circled: backing up is the
// governor's ladder's, planners/navigation/car_ladder.h). The loop is that of car_response.h.
// Memoryless. Told to stand, it does not turn. Assumes that what it returns is applied one step
// later.
class CarTracker : public Regulator {
 public:
  // `period_s` is the time between two calls.
  CarTracker(const CarTrackerConfig& config, const CarConfig& vehicle, const MotionLimits& limits,
             double period_s);

  void reset(const VehicleState&) override {}
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  MotionResponse motion_response() const override { return response_; }

 private:
  ArcCommand wanted(const Setpoint& setpoint, const VehicleState& state) const;

  CarResponse response_;
  SpeedProfile profile_;
};

}  // namespace voronaut
