#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// What a report draws of a trial: plain numbers, so that a stored run can be drawn again without a
// planner at hand. World frame W, SI units. `benchmarks` fills it from an episode's log.
namespace voronaut {

struct TracePoint {
  double x_m = 0;
  double y_m = 0;
};

// The true world a trial ran in. Stored once per world_id.
struct TraceWorld {
  std::string world_id;
  TracePoint bounds_min, bounds_max;
  std::vector<std::array<double, 3>> circles;  // x, y, radius
  std::vector<std::vector<TracePoint>> polygons;
  std::vector<std::array<TracePoint, 2>> segments;
  TracePoint start, goal;
};

// One moment, recorded at every scan (20 Hz) and at the end.
struct TraceFrame {
  double t_s = 0;
  double x_m = 0, y_m = 0, z_m = 0;
  double vx_m_s = 0, vy_m_s = 0;
  double heading_x = 1, heading_y = 0;
  double tilt_rad = 0;
  double clearance_m = 0;  // true, centre to surface
  std::array<double, 4> actuators{};
  double planning_time_us = 0;
  double target_x_m = 0, target_y_m = 0;  // the setpoint
  int mode = -1;                          // index into Trace::modes, -1: none
  int plan = -1;                          // index into Trace::plans, -1: none
  int search = -1;                        // the latest search by then (TraceEdge), -1: none kept
  int replan = -1;                        // index into Trace::replan_reasons, -1: kept its plan
  int solve_end = -1;                     // index into Trace::solve_ends, -1: no solve
  std::size_t known_points = 0;           // how many of Trace::known_points were known by then
  double speed_scale = 1;                 // of the speed asked for, as the governor allowed it
  std::vector<TracePoint> tube;           // corners of the governor's proved track; empty: none
  // The scan taken now, rightmost beam first; empty: none. Beyond (0, max range): no return.
  std::vector<float> range_m;
};

// An edge of the roadmap or of the trees that a planner searched, from its first such search to its
// last: neighbouring searches share most of a roadmap.
struct TraceEdge {
  TracePoint a, b;
  int first_search = 0;
  int last_search = 0;
};

// From frame `frame` on what had label `from` has label `into`.
struct TraceMerge {
  std::uint32_t frame = 0;
  std::uint32_t from = 0;
  std::uint32_t into = 0;
};

// The best cost of an anytime planner after so much work, whenever it became better.
struct TraceImprovement {
  std::int64_t state_checks = 0;
  double time_s = 0;  // wall clock
  double cost_m = 0;
};

struct Trace {
  std::string trial_id;
  bool static_planning = false;  // nobody flew, the frames walk along the path at 1 m/s
  double body_radius_m = 0;
  std::vector<TracePoint> footprint;  // corners in the body's frame (x forward); empty: the disc
  double clearance_min_m = 0;
  double field_of_view_rad = 0;
  double max_range_m = 0;
  std::vector<std::string> modes;
  std::vector<std::string> replan_reasons;
  std::vector<std::string> solve_ends;  // what ended a solve: a budget, or the planner itself
  std::vector<std::vector<TracePoint>> plans;  // in the order in which they were made
  std::vector<TracePoint> known_points;        // in the order in which they became known
  std::vector<std::uint32_t> cluster_of;       // label of each known point when it became known
  std::vector<TraceMerge> merges;              // in order of time
  std::vector<std::vector<TracePoint>> hulls;  // of the clusters at the end
  std::vector<TraceEdge> edges;                // in the order of their first search
  int searches = 0;                            // that there were
  int kept_searches = 0;  // of them, the first ones: what a replay has room for
  std::vector<TraceImprovement> improvements;  // of a static plan
  std::vector<TraceFrame> frames;
};

}  // namespace voronaut
