#pragma once

#include <cstdint>

namespace voronaut {

// Clocks and verdicts of the loop; all times are simulated.
struct LoopConfig {
  double vehicle_period_s = 0.01;
  double time_limit_base_s = 40;
  double time_limit_s_per_m = 10;
  double goal_hold_s = 1;
  double stuck_after_s = 20;
  double stuck_radius_m = 0.25;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("vehicle_period_s", vehicle_period_s, 0.001, 0.1,
             "The papers' T: one step of vehicle and regulator");
    v.number("time_limit_base_s", time_limit_base_s, 0, 1e6,
             "Outcome timeout after so long, plus time_limit_s_per_m");
    v.number("time_limit_s_per_m", time_limit_s_per_m, 0, 1e6,
             "So much longer per metre of shortest path");
    v.number("goal_hold_s", goal_hold_s, 0, 60, "No contact for so long after reaching the goal");
    v.number("stuck_after_s", stuck_after_s, 1, 1e6,
             "Outcome stuck after so long within stuck_radius_m");
    v.number("stuck_radius_m", stuck_radius_m, 0.01, 10,
             "See stuck_after_s; measured from where the time began");
  }
};

}  // namespace voronaut
