#pragma once

#include "voronaut/dynamics/motion_response.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/dynamics/stopping.h"

namespace voronaut {

// How a body is made to follow a setpoint. Called once per vehicle step; what it returns is applied
// one step later (the transport delay of the papers' sampled law), which is the caller's business.
class Regulator {
 public:
  virtual ~Regulator() = default;

  // Forget the past; `state` is the first that regulate() will see.
  virtual void reset(const VehicleState& state) = 0;

  virtual Command regulate(const Setpoint& setpoint, const VehicleState& state) = 0;

  // How what it drives stops when told to. A law that does not stop says how it would if it did.
  virtual StoppingLaw stopping_law() const = 0;

  // How motion answers a command: what the safety governor predicts with. Throws
  // std::invalid_argument with the reason where no stop can be promised. What moves in every
  // direction says it by velocity_response(); what drives along its heading overrides this one.
  virtual MotionResponse motion_response() const { return velocity_response(); }
  virtual VelocityResponse velocity_response() const;
};

}  // namespace voronaut
