#pragma once

#include "voronaut/dynamics/model.h"

namespace voronaut {

class Car;

// Of the size of F1TENTH's car, whose simulator has these numbers (f1tenth_gym's defaults: lf + lr,
// s_max, sv_max; its 20 m/s and 9.51 m/s^2 are for racing).
struct CarConfig {
  using Body = Car;
  static constexpr const char* kName = "car";

  double wheelbase_m = 0.3302;
  double max_steering_rad = 0.4189;
  double max_steering_rate_rad_s = 3.2;
  double max_acceleration_m_s2 = 9.51;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("wheelbase_m", wheelbase_m, 0.01, 100, "From the rear axle to the front axle");
    v.number("max_steering_rad", max_steering_rad, 0.01, 1.5, "Largest angle of the front wheels");
    v.number("max_steering_rate_rad_s", max_steering_rate_rad_s, 0.01, 100,
             "They turn no faster, standing or driving");
    v.number("max_acceleration_m_s2", max_acceleration_m_s2, 0.01, 1000,
             "Its speed changes no faster");
  }
};

// Kinematic bicycle: heading' = v tan(steering) / wheelbase. Command: acceleration [m/s^2] and
// steering rate [rad/s], each clipped to its limit, the rate so that the steering angle keeps to
// its own; the other two numbers are not used. One RK4 step per period. Rolls without slip on level
// ground: VehicleState::p_world is the middle of the rear axle, its height never changes, velocity
// is along the heading. The first of VehicleState::actuators is the steering angle [rad], positive
// to the left; the others stay 0.
class Car : public Model {
 public:
  explicit Car(const CarConfig& config = {}) : config_(config) {}

  Mobility mobility() const override { return {.flies = false, .moves_sideways = false}; }
  VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const override;
  Command hold() const override { return {}; }
  VehicleState step(const VehicleState& state, const Command& command,
                    double period_s) const override;

 private:
  CarConfig config_;
};

}  // namespace voronaut
