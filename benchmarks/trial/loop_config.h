#pragma once

#include <cstdint>

namespace voronaut {

// Clocks and verdicts of the loop; all times are simulated.
struct LoopConfig {
  double vehicle_period_s = 0.01;  // the papers' T
  double time_limit_base_s = 40;   // outcome timeout after base + per metre of shortest path
  double time_limit_s_per_m = 10;
  double goal_hold_s = 1;     // no contact for so long after reaching the goal
  double stuck_after_s = 20;  // within stuck_radius_m for so long
  double stuck_radius_m = 0.25;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("vehicle_period_s", vehicle_period_s, 0.001, 0.1);
    v.number("time_limit_base_s", time_limit_base_s, 0, 1e6);
    v.number("time_limit_s_per_m", time_limit_s_per_m, 0, 1e6);
    v.number("goal_hold_s", goal_hold_s, 0, 60);
    v.number("stuck_after_s", stuck_after_s, 1, 1e6);
    v.number("stuck_radius_m", stuck_radius_m, 0.01, 10);
  }
};

}  // namespace voronaut
