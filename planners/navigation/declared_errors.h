#pragma once

#include "voronaut/planners/mapping/free_space/doubted_scan.h"

namespace voronaut {

// What navigation is told of what is not exact, as bounds. By default everything is.
struct DeclaredErrors {
  SensingErrors sensing = {};
  double stop_per_speed_s = 0;
  double planning_room_m = 0;
  double latency_s = 0;
  double pose_gain = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("range_m", sensing.range_m, 0, 10,
             "A return may be so far off: the governor keeps it from what it takes for free");
    v.number("position_m", sensing.position_m, 0, 10,
             "So may the vehicle's position, of scans and of stops: it keeps it from both");
    v.number("heading_rad", sensing.heading_rad, 0, 1, "So may its heading");
    v.number("stop_per_speed_s", stop_per_speed_s, 0, 1,
             "A stop may stray so much more, per speed, than the vehicle promises");
    v.number(
        "planning_room_m", planning_room_m, 0, 10,
        "Planners keep so much more than planning_clearance_m, half of it where that leaves no "
        "path, else nothing more");
    v.number("latency_s", latency_s, 0, 1,
             "Commands act so much later: state is predicted until then");
    v.number("pose_gain", pose_gain, 0.001, 1,
             "Share of each pose told in what is believed, the rest is dead reckoning; 1: as told");
  }
};

}  // namespace voronaut
