#pragma once

#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/models/quadrotor.h"
#include "voronaut/dynamics/velocity_response.h"

namespace voronaut {

// A quadrotor's loops about hover, as its regulator closes them: da'/dt = gain (a_d - a) - damping
// a'.
struct TiltLoop {
  double velocity_gain_1_s;  // a_d per error of velocity
  double gain_1_s2;
  double damping_1_s;
};

// By how much flown stops stray from those predicted, for each m/s by the set of inertia.
struct TiltStopError {
  double at_rest_m;
  double agile_s;     // corrected inertia
  double sluggish_s;  // printed: the rotors saturate
};

// What the governor predicts by where a regulator allocates thrust and torque (rotor_allocation.h).
VelocityResponse tilt_response(const QuadrotorConfig& vehicle, const MotionLimits& limits,
                               const TiltLoop& loop, const TiltStopError& error, double period_s);

}  // namespace voronaut
