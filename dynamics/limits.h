#pragma once

#include "voronaut/dynamics/stopping.h"

namespace voronaut {

// What a vehicle is allowed to do; its body may be able to do more.
struct MotionLimits {
  double max_speed_m_s = 2.5;
  double max_acceleration_m_s2 = 3;
  double max_yaw_rate_rad_s = 2;
  // 20 deg; asked for: the quadrotor overshoots it by 1 deg from rest, 4 deg reversing at full
  // speed.
  double max_tilt_rad = 0.349065850;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("max_speed_m_s", max_speed_m_s, 0.01, 100, "Fastest horizontal speed it is asked for");
    v.number("max_acceleration_m_s2", max_acceleration_m_s2, 0.01, 1000,
             "Strongest horizontal acceleration it is asked for");
    v.number("max_yaw_rate_rad_s", max_yaw_rate_rad_s, 0, 100, "Fastest turn it is asked for");
    v.number("max_tilt_rad", max_tilt_rad, 0, 1.2,
             "Largest tilt it is asked for; 0 for what does not tilt");
  }
};

}  // namespace voronaut
