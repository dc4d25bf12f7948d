#pragma once

#include "voronaut/dynamics/model.h"

namespace voronaut {

class Unicycle;

struct UnicycleConfig {
  using Body = Unicycle;
  static constexpr const char* kName = "unicycle";

  double max_speed_m_s = 2.5;
  double max_acceleration_m_s2 = 3;
  double max_yaw_rate_rad_s = 2;
  double max_yaw_acceleration_rad_s2 = 10;
  double drive_lag_s = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("max_speed_m_s", max_speed_m_s, 0.01, 100, "Speeds asked for are clipped to it");
    v.number("max_acceleration_m_s2", max_acceleration_m_s2, 0.01, 1000,
             "Its speed changes no faster");
    v.number("max_yaw_rate_rad_s", max_yaw_rate_rad_s, 0.01, 100,
             "Yaw rates asked for are clipped to it");
    v.number("max_yaw_acceleration_rad_s2", max_yaw_acceleration_rad_s2, 0.01, 1000,
             "Its yaw rate changes no faster");
    v.number("drive_lag_s", drive_lag_s, 0, 5,
             "First-order lag with which speed and yaw rate follow what is asked for; 0: none");
  }
};

// Whatever drives along its heading and turns on the spot, without masses or motors: a differential
// drive whose wheels' controller is taken for granted. Command: speed [m/s] and yaw rate [rad/s]
// asked for, each clipped to its limit; the other two numbers are not used. Either follows by
//   dv/dt = clip((v asked - v) / drive_lag, limit),
// which is solved exactly; the position is integrated by Simpson's rule between the kinks of that
// answer, to 1e-10 m a step of 0.01 s at 4 rad/s. Rolls without slip on level ground:
// VehicleState::p_world is the middle of the axle, its height never changes, velocity is along the
// heading. VehicleState::actuators stay 0.
class Unicycle : public Model {
 public:
  explicit Unicycle(const UnicycleConfig& config = {}) : config_(config) {}

  Mobility mobility() const override { return {.flies = false, .moves_sideways = false}; }
  VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const override;
  Command hold() const override { return {}; }
  VehicleState step(const VehicleState& state, const Command& command,
                    double period_s) const override;

 private:
  UnicycleConfig config_;
};

}  // namespace voronaut
