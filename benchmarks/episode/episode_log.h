#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "voronaut/benchmarks/episode/cluster_history.h"
#include "voronaut/benchmarks/episode/referee.h"
#include "voronaut/benchmarks/episode/search_trace.h"
#include "voronaut/dynamics/path.h"
#include "voronaut/dynamics/state.h"
#include "voronaut/planners/navigation/navigation_report.h"
#include "voronaut/planners/problem/planning_budget.h"

// What happened in an episode, tick by tick: the only source of metrics and traces.
namespace voronaut {

// After each vehicle step.
struct Tick {
  double t_s = 0;
  VehicleState state;
  double clearance_m = 0;  // centre to the true surface
};

// At each scan.
struct ScanEvent {
  std::size_t tick = 0;                 // index of the state in which the scan was taken
  Setpoint setpoint;                    // in force after it
  Vec2 lookahead_world = Vec2::Zero();  // the point that the setpoint heads for
  int mode = -1;                        // index into EpisodeLog::modes
  int plan = -1;                        // index into EpisodeLog::plans: the one being followed
  int search = -1;                      // number of the latest in EpisodeLog::searches
  ReplanReason replan = ReplanReason::none;
  SolveEnd solve_end = SolveEnd::planner;  // of the solve that `replan` asked for
  std::size_t known_points = 0;            // of the map, without virtual obstacles
  ExecutiveState executive = ExecutiveState::takeoff;
  // Of the centre from the path that is followed; NaN without one.
  double path_distance_m = std::numeric_limits<double>::quiet_NaN();
  double speed_scale = 1;             // of the speed asked for, as the governor allowed it
  std::vector<Eigen::Vector2d> tube;  // the governor's proved track, corners; empty: none
  double planning_time_us = 0;
  std::vector<float> range_m;  // empty unless the episode keeps scans
};

// Wall time of one stage of the loop, one sample per start and stop.
class StageTimes {
 public:
  void start() { started_ = Clock::now(); }
  void stop() {
    const std::chrono::duration<double, std::micro> spent = Clock::now() - started_;
    samples_us_.push_back(spent.count());
  }
  const std::vector<double>& samples_us() const { return samples_us_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point started_;
  std::vector<double> samples_us_;
};

struct EpisodeLog {
  std::vector<Tick> ticks;  // the first is the start, at t = 0
  std::vector<ScanEvent> scans;
  std::vector<std::string> modes;  // in the order of their first use
  std::vector<Path> plans;
  SearchHistory searches;   // edges looked at; only if the episode keeps scans
  ClusterHistory clusters;  // the same
  double departure_s = 0;   // when the vehicle had its height and set off
  std::int64_t replans = 0;
  std::array<std::int64_t, kSolveEnds> solve_ends{};  // of the replans, by SolveEnd
  Verdict verdict{Outcome::invalid, ""};
  double end_s = 0;
  double body_clearance_smallest_m = 0;  // body's surface to the true surface

  StageTimes mapping;
  StageTimes planning;
  StageTimes step;
};

}  // namespace voronaut
