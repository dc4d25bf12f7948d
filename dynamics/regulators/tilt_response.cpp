#include "voronaut/dynamics/regulators/tilt_response.h"

#include "voronaut/dynamics/regulators/rotor_allocation.h"

namespace voronaut {

VelocityResponse tilt_response(const QuadrotorConfig& vehicle, const MotionLimits& limits,
                               const TiltLoop& loop, const TiltStopError& error, double period_s) {
  VelocityResponse response;
  response.period_s = period_s;
  response.k_1_s = loop.velocity_gain_1_s;
  response.a_max_m_s2 = vehicle.max_acceleration_m_s2(limits);
  response.gravity_m_s2 = vehicle.gravity_m_s2;
  response.gain_1_s2 = loop.gain_1_s2;
  response.damping_1_s = loop.damping_1_s;
  response.push_max_m_s4 = vehicle.gravity_m_s2 * RotorAllocation(vehicle).max_tilt_torque_N_m() /
                           vehicle.inertia_kg_m2().x();
  response.error_at_rest_m = error.at_rest_m;
  response.error_per_speed_s =
      vehicle.inertia == QuadrotorConfig::InertiaSet::corrected ? error.agile_s : error.sluggish_s;
  return response;
}

}  // namespace voronaut
