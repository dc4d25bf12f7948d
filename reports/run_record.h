#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

// One trial, one row: the type that benchmarks produce and every writer and report reads.
namespace voronaut {

enum class Outcome {
  goal_reached,   // at rest at the goal without a contact
  collision,      // the body met an obstacle of the true world
  out_of_bounds,  // the centre left the bounds of the scenario
  timeout,        // simulated time ran out
  stuck,          // stood still until it was pointless to wait
  infeasible,     // the planner proved that there is no path on what is known
  invalid,        // the trial could not start: start or goal not free, planner refused
  killed,         // stopped by the wall-clock or CPU limit
  crash,          // the planner ended the process: signal, abort, exception
  memory,         // the planner asked for more memory than allowed
};

inline constexpr std::array kOutcomes{
    Outcome::goal_reached, Outcome::collision,  Outcome::out_of_bounds, Outcome::timeout,
    Outcome::stuck,        Outcome::infeasible, Outcome::invalid,       Outcome::killed,
    Outcome::crash,        Outcome::memory};

std::string_view to_string(Outcome outcome);
// Throws std::invalid_argument for an unknown name.
Outcome outcome_from_string(std::string_view name);

// Absent numbers are NaN in memory, NULL in SQL, empty in CSV.
inline constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

enum class ColumnKind {
  deterministic,  // equal on every run of the same trial: part of the digest
  measured,       // wall times and what hangs on them
};

struct RunRecord {
  std::string trial_id;  // hash of everything that defines the trial; the build is not part of it
  std::string suite;
  std::string scenario;        // name of the scenario
  std::string scenario_group;  // family it is summarised under
  std::string world_id;        // hash of the true world: key into the table of worlds
  std::string vehicle;
  std::string regulator;
  std::string planner;  // label in the suite
  std::int64_t repetition = 0;
  std::int64_t seed = 0;  // of the planner; fits SQLite's signed integer
  Outcome outcome = Outcome::invalid;
  std::string reason;  // one line for a human: where and why it ended

  double duration_s = kAbsent;               // simulated, from the first step to the verdict
  double path_length_m = kAbsent;            // flown, in the plane
  double shortest_length_m = kAbsent;        // privileged, at body radius on the true world
  double shortest_at_clearance_m = kAbsent;  // the same at clearance_min_m
  // (flown + straight rest to the goal) / shortest, each counted as the goal's tolerance at least;
  // goal_reached only
  double path_ratio = kAbsent;
  double spl = kAbsent;              // success weighted by path length, 0 for a failure
  double clearance_min_m = kAbsent;  // centre to surface of the true world, under way
  double clearance_mean_m = kAbsent;
  double speed_mean_m_s = kAbsent;  // from departure to the verdict
  double speed_max_m_s = kAbsent;
  double end_x_m = kAbsent;  // where it ended
  double end_y_m = kAbsent;
  std::int64_t replans = 0;
  std::int64_t state_checks = 0;
  std::int64_t budget_stops =
      0;  // solves that ended because the budget was spent, by the limit met:
  std::int64_t stops_state_checks = 0;
  std::int64_t stops_ptc_evaluations = 0;
  std::int64_t stops_iterations = 0;
  std::int64_t stops_wall_clock = 0;
  std::int64_t stops_first_solution =
      0;  // anytime planners told to stop there; others by themselves
  std::int64_t map_points = 0;
  std::int64_t map_obstacles = 0;
  std::string modes;         // modes or executive states in the order of first use
  std::string state_digest;  // hash over every vehicle state of the trial

  double mapping_time_us_mean = kAbsent;
  double mapping_time_us_p99 = kAbsent;
  double planning_time_us_mean = kAbsent;
  double planning_time_us_p99 = kAbsent;
  double step_time_us_mean = kAbsent;  // sense, map, plan, navigate, regulate, integrate
  double step_time_us_p99 = kAbsent;
  double cpu_time_s = kAbsent;
  double memory_max_mb = kAbsent;

  // The one list of columns: v(name, member, kind), in the order of the table. A member is a
  // std::string, a std::int64_t, a double or an Outcome.
  template <class Visitor>
  void visit(Visitor&& v) {
    visit_members(*this, v);
  }
  template <class Visitor>
  void visit(Visitor&& v) const {
    visit_members(*this, v);
  }

 private:
  template <class Self, class Visitor>
  static void visit_members(Self& self, Visitor& v) {
    const auto d = ColumnKind::deterministic;
    const auto m = ColumnKind::measured;
    v("trial_id", self.trial_id, d);
    v("suite", self.suite, d);
    v("scenario", self.scenario, d);
    v("scenario_group", self.scenario_group, d);
    v("world_id", self.world_id, d);
    v("vehicle", self.vehicle, d);
    v("regulator", self.regulator, d);
    v("planner", self.planner, d);
    v("repetition", self.repetition, d);
    v("seed", self.seed, d);
    v("outcome", self.outcome, d);
    v("reason", self.reason, d);
    v("duration_s", self.duration_s, d);
    v("path_length_m", self.path_length_m, d);
    v("shortest_length_m", self.shortest_length_m, d);
    v("shortest_at_clearance_m", self.shortest_at_clearance_m, d);
    v("path_ratio", self.path_ratio, d);
    v("spl", self.spl, d);
    v("clearance_min_m", self.clearance_min_m, d);
    v("clearance_mean_m", self.clearance_mean_m, d);
    v("speed_mean_m_s", self.speed_mean_m_s, d);
    v("speed_max_m_s", self.speed_max_m_s, d);
    v("end_x_m", self.end_x_m, d);
    v("end_y_m", self.end_y_m, d);
    v("replans", self.replans, d);
    v("state_checks", self.state_checks, d);
    v("budget_stops", self.budget_stops, d);
    v("stops_state_checks", self.stops_state_checks, d);
    v("stops_ptc_evaluations", self.stops_ptc_evaluations, d);
    v("stops_iterations", self.stops_iterations, d);
    v("stops_wall_clock", self.stops_wall_clock, d);
    v("stops_first_solution", self.stops_first_solution, d);
    v("map_points", self.map_points, d);
    v("map_obstacles", self.map_obstacles, d);
    v("modes", self.modes, d);
    v("state_digest", self.state_digest, d);
    v("mapping_time_us_mean", self.mapping_time_us_mean, m);
    v("mapping_time_us_p99", self.mapping_time_us_p99, m);
    v("planning_time_us_mean", self.planning_time_us_mean, m);
    v("planning_time_us_p99", self.planning_time_us_p99, m);
    v("step_time_us_mean", self.step_time_us_mean, m);
    v("step_time_us_p99", self.step_time_us_p99, m);
    v("cpu_time_s", self.cpu_time_s, m);
    v("memory_max_mb", self.memory_max_mb, m);
  }
};

}  // namespace voronaut
