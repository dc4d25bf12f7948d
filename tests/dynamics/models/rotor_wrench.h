#pragma once

#include "voronaut/dynamics/regulators/rotor_allocation.h"

namespace voronaut::testing {

// Eq. (2) of the quadrotor paper: thrust and torques of four rotor speeds.
inline Wrench wrench_of(const QuadrotorConfig& c, const Command& command) {
  double s[4];
  for (std::size_t i = 0; i < 4; ++i) s[i] = command.u[i] * command.u[i];
  const double moment = c.thrust_factor_N_s2 * c.arm_m;
  return {c.thrust_factor_N_s2 * (s[0] + s[1] + s[2] + s[3]),
          {moment * (s[3] - s[1]), moment * (s[2] - s[0]),
           c.drag_factor_N_m_s2 * (s[1] + s[3] - s[0] - s[2])}};
}

}  // namespace voronaut::testing
