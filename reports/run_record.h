#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "voronaut/reports/outcome.h"

// One trial, one row: the type that benchmarks produce and every writer and report reads. What each
// member means stands in reports/record_columns.cpp.
namespace voronaut {

// Absent numbers are NaN in memory, NULL in SQL, empty in CSV.
inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

struct RunRecord {
  std::string trial_id;
  std::string suite;
  std::string scenario;
  std::string scenario_group;
  std::string world_id;
  std::string vehicle;
  std::string regulator;
  std::string planner;
  std::int64_t repetition = 0;
  std::int64_t seed = 0;
  Outcome outcome = Outcome::invalid;
  std::string reason;

  double duration_s = kAbsent;
  double path_length_m = kAbsent;
  double shortest_length_m = kAbsent;
  double shortest_at_clearance_m = kAbsent;
  double free_share = kAbsent;
  double narrowest_passage_m = kAbsent;
  double path_ratio = kAbsent;
  double spl = kAbsent;
  double clearance_smallest_m = kAbsent;
  double clearance_mean_m = kAbsent;
  double body_clearance_smallest_m = kAbsent;
  double speed_mean_m_s = kAbsent;
  double speed_max_m_s = kAbsent;
  double end_x_m = kAbsent;
  double end_y_m = kAbsent;
  double barn_time_s = kAbsent;
  double barn_score = kAbsent;
  double barn_pace = kAbsent;
  std::int64_t replans = 0;
  std::int64_t state_checks = 0;
  std::int64_t budget_stops = 0;
  std::int64_t stops_state_checks = 0;
  std::int64_t stops_ptc_evaluations = 0;
  std::int64_t stops_iterations = 0;
  std::int64_t stops_wall_clock = 0;
  std::int64_t stops_first_solution = 0;
  std::int64_t map_points = 0;
  std::int64_t map_obstacles = 0;
  std::string modes;
  std::string state_digest;

  double tracking_error_rms_m = kAbsent;
  double tracking_error_max_m = kAbsent;
  double energy_j = kAbsent;
  double settling_s = kAbsent;
  double overshoot_m = kAbsent;
  double stopping_distance_m = kAbsent;

  double mapping_time_us_mean = kAbsent;
  double mapping_time_us_p99 = kAbsent;
  double planning_time_us_mean = kAbsent;
  double planning_time_us_p99 = kAbsent;
  double step_time_us_mean = kAbsent;
  double step_time_us_p99 = kAbsent;
  double cpu_time_s = kAbsent;
  double memory_max_mb = kAbsent;
};

}  // namespace voronaut
