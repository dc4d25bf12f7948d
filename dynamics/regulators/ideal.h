#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/ideal.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/dynamics/speed_profile.h"

namespace voronaut {

class IdealRegulator;

struct IdealRegulatorConfig {
  using Law = IdealRegulator;
  static constexpr const char* kName = "ideal";

  double velocity_gain_1_s = 1.786;
  double height_gain_1_s = 1.667;
  double climb_gain_1_s = 5.4;
  double yaw_gain_1_s = 2;
  SpeedProfileConfig profile;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("velocity_gain_1_s", velocity_gain_1_s, 0.01, 50,
             "Acceleration per error of velocity; the default stops like pd_rate");
    v.number("height_gain_1_s", height_gain_1_s, 0.01, 50, "Climb per error of height");
    v.number("climb_gain_1_s", climb_gain_1_s, 0.01, 50,
             "Vertical acceleration per error of climb");
    v.number("yaw_gain_1_s", yaw_gain_1_s, 0, 50, "Yaw rate per error of heading");
    profile.visit(v);
  }
};

// For the ideal vehicle: acceleration clip(k (V_desired - V), a_max), turning towards the heading.
// Memoryless. Height comes first where the two compete for a_max.
class IdealRegulator : public Regulator {
 public:
  // `period_s` is the time between two calls.
  IdealRegulator(const IdealRegulatorConfig& config, const IdealConfig& vehicle,
                 const MotionLimits& limits, double period_s);

  void reset(const VehicleState&) override {}
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override;
  StoppingLaw stopping_law() const override;
  VelocityResponse velocity_response() const override;

 private:
  IdealRegulatorConfig config_;
  MotionLimits limits_;
  double period_s_;
  double vehicle_acceleration_m_s2_;  // what its body can do
  SpeedProfile profile_;
};

}  // namespace voronaut
