#pragma once

#include "voronaut/dynamics/state.h"

namespace voronaut {

// Rotor speed differences [rad/s] asked for by a regulator, in the body's axes.
struct RotorDemand {
  double collective = 0;  // w_yc of eq. (3): the mean speed
  double forward = 0;     // w_xc: the pair 3-1, accelerates along body x
  double right = 0;       // w_zc: the pair 4-2, accelerates along body -y
  double yaw = 0;         // added to 2 and 4, taken from 1 and 3: turns left
};

// Eq. (3) of the quadrotor planner paper, w_yc -+ w_xc/2 and -+ w_zc/2, plus yaw. As printed, the
// fourth entry is w_yc + w_zc, which couples the pair 2-4 into thrust and yaw: `typo_in_eq3`.
inline Command mixed(const RotorDemand& demand, bool typo_in_eq3 = false) {
  const double half_right = 0.5 * demand.right;
  return {{demand.collective - 0.5 * demand.forward - demand.yaw,
           demand.collective - half_right + demand.yaw,
           demand.collective + 0.5 * demand.forward - demand.yaw,
           demand.collective + (typo_in_eq3 ? demand.right : half_right) + demand.yaw}};
}

}  // namespace voronaut
