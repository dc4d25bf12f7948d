#pragma once

#include <limits>

#include "voronaut/dynamics/state.h"

namespace voronaut {

// What a body can do at all, whatever regulates it.
struct Mobility {
  bool flies = true;           // false: stays on the ground, at the height it starts from
  bool moves_sideways = true;  // false: only along its heading, so it looks where it goes
};

// How a body moves. A model is a pure function of state and command: it keeps no state of its own.
class Model {
 public:
  virtual ~Model() = default;

  virtual Mobility mobility() const = 0;

  // At rest at p_world, level, looking along `heading_world` (unit vector).
  virtual VehicleState at_rest(const Vec3& p_world, const Eigen::Vector2d& heading_world) const = 0;

  // The command that keeps a vehicle at rest where it is: what is applied before the first one.
  virtual Command hold() const = 0;

  // The state `period_s` later under `command` held constant.
  virtual VehicleState step(const VehicleState& state, const Command& command,
                            double period_s) const = 0;

  // Mechanical power that its actuators give off at the end of a step [W]; NaN of a model that has
  // none.
  virtual double power_w(const VehicleState&) const {
    return std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace voronaut
