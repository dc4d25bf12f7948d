#pragma once

#include "voronaut/dynamics/state.h"

namespace voronaut {

// How a body is made to follow a setpoint. Called once per vehicle step; what it returns is applied
// one step later (the transport delay of the papers' sampled law), which is the caller's business.
class Regulator {
 public:
  virtual ~Regulator() = default;

  // Forget the past; `state` is the first that regulate() will see.
  virtual void reset(const VehicleState& state) = 0;

  virtual Command regulate(const Setpoint& setpoint, const VehicleState& state) = 0;
};

}  // namespace voronaut
