#pragma once

#include "voronaut/dynamics/models/quadrotor.h"

namespace voronaut::testing {

// No rotor limits, so that rotors may stand still.
inline QuadrotorConfig free_rotors(
    QuadrotorConfig::InertiaSet inertia = QuadrotorConfig::InertiaSet::corrected) {
  QuadrotorConfig config;
  config.inertia = inertia;
  config.min_rotor_speed_rad_s = 0;
  config.max_rotor_speed_rad_s = 1000;
  return config;
}

inline VehicleState level(const Vec3& p, const Vec3& v = Vec3::Zero(),
                          const Vec3& w = Vec3::Zero()) {
  VehicleState state;
  state.p_world = p;
  state.v_world = v;
  state.w_body = w;
  return state;
}

inline double worst(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

inline double attitude_difference(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double sign = a.dot(b) < 0 ? -1 : 1;
  return (a.coeffs() - sign * b.coeffs()).cwiseAbs().maxCoeff();
}

// The rotor speeds of reference flight R1 [rad/s].
inline const Command kR1{{212, 214.5, 213, 215}};

}  // namespace voronaut::testing
