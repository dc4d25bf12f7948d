#pragma once

#include "voronaut/dynamics/model.h"

namespace voronaut {

class Ideal;

struct IdealConfig {
  using Body = Ideal;
  static constexpr const char* kName = "ideal";

  double max_acceleration_m_s2 = 3;
  double max_yaw_rate_rad_s = 2;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("max_acceleration_m_s2", max_acceleration_m_s2, 0.01, 1000,
             "Accelerations are shortened to it");
    v.number("max_yaw_rate_rad_s", max_yaw_rate_rad_s, 0, 100, "Yaw rates are clipped to it");
  }
};

// A point mass that is always level, for runs in which only the planner matters. Command: world
// acceleration x, y, z [m/s^2], shortened to the limit, and yaw rate [rad/s], clipped to it; both
// held over the step, which is integrated exactly. VehicleState::actuators stay 0.
class Ideal : public Model {
 public:
  explicit Ideal(const IdealConfig& config = {}) : config_(config) {}

  Mobility mobility() const override { return {}; }
  VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const override;
  Command hold() const override { return {}; }
  VehicleState step(const VehicleState& state, const Command& command,
                    double period_s) const override;

 private:
  IdealConfig config_;
};

}  // namespace voronaut
