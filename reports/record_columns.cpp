#include "voronaut/reports/record_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace voronaut {

namespace {

using enum TrialSet;
using R = RunRecord;
constexpr ColumnKind exact = ColumnKind::deterministic;
constexpr ColumnKind beside = ColumnKind::repeatable;
constexpr ColumnKind measured = ColumnKind::measured;

// Name, member, kind, over which trials, unit, what it is. A new column is a line here, one in
// RunRecord, and a higher ResultStore::kSchemaVersion.
const RecordColumn kColumns[] = {
    // clang-format off
    {"trial_id", &R::trial_id, exact, all, "", "hash of everything that defines the trial; the build is not part of it"},
    {"suite", &R::suite, exact, all, "", "name of the suite"},
    {"scenario", &R::scenario, exact, all, "", "name of the scenario"},
    {"scenario_group", &R::scenario_group, exact, all, "", "family of scenarios it is summarised under"},
    {"world_id", &R::world_id, exact, all, "", "hash of the true world: key into the table of worlds"},
    {"vehicle", &R::vehicle, exact, all, "", "label of the vehicle"},
    {"regulator", &R::regulator, exact, all, "", "name of the regulator"},
    {"planner", &R::planner, exact, all, "", "label of the planner"},
    {"repetition", &R::repetition, exact, all, "", "which repetition, from 0"},
    {"seed", &R::seed, exact, all, "", "seed of the planner"},
    {"outcome", &R::outcome, exact, all, "", "how it ended"},
    {"reason", &R::reason, exact, all, "", "where and why it ended, one line"},
    {"duration_s", &R::duration_s, exact, moved, "s", "simulated time from the first step to the verdict"},
    {"path_length_m", &R::path_length_m, exact, moved, "m", "length of the path flown, in the plane"},
    {"shortest_length_m", &R::shortest_length_m, exact, all, "m", "shortest path of the body, or of the largest disc within its polygon, through the true world"},
    {"shortest_at_clearance_m", &R::shortest_at_clearance_m, exact, all, "m", "shortest path at the clearance that planners must keep (planning_clearance_m)"},
    {"free_share", &R::free_share, beside, all, "", "share of the bounds that no solid of the true world covers"},
    {"narrowest_passage_m", &R::narrowest_passage_m, beside, all, "m", "diameter of the largest disc that gets from start to goal in the true world, its centre within the bounds; 0 if none does, absent if any does"},
    {"path_ratio", &R::path_ratio, exact, goal_reached, "", "path flown, with the straight rest to the goal, over the shortest one of the body, each counted as the goal's tolerance at least"},
    {"spl", &R::spl, exact, all, "", "success weighted by path length; 0 for a failure"},
    {"clearance_smallest_m", &R::clearance_smallest_m, exact, moved, "m", "smallest clearance under way, centre to the surface of the true world"},
    {"clearance_mean_m", &R::clearance_mean_m, exact, moved, "m", "mean clearance under way, centre to the surface of the true world"},
    {"body_clearance_smallest_m", &R::body_clearance_smallest_m, beside, moved, "m", "smallest distance under way between the surface of the body, its disc or its polygon as it is turned, and that of the true world; 0 at a contact"},
    {"speed_mean_m_s", &R::speed_mean_m_s, exact, moved, "m/s", "mean speed from departure to the verdict"},
    {"speed_max_m_s", &R::speed_max_m_s, exact, moved, "m/s", "highest speed"},
    {"end_x_m", &R::end_x_m, exact, moved, "m", "x of the place where it ended"},
    {"end_y_m", &R::end_y_m, exact, moved, "m", "y of the place where it ended"},
    {"barn_time_s", &R::barn_time_s, beside, goal_reached, "s", "time to the goal by the clock of the BARN challenge, which starts when the robot has moved 0.1 m"},
    {"barn_score", &R::barn_score, beside, all, "", "score of the BARN challenge since 2024, at most 0.5; 0 for a failure; only of its courses"},
    {"barn_pace", &R::barn_pace, beside, goal_reached, "", "the same without its bounds: the course's length at 2 m/s over barn_time_s"},
    {"replans", &R::replans, exact, all, "", "how often the planner was asked"},
    {"state_checks", &R::state_checks, exact, all, "", "states that the planner had checked; the same on every machine"},
    {"budget_stops", &R::budget_stops, exact, all, "", "solves that ended because the budget was spent"},
    {"stops_state_checks", &R::stops_state_checks, exact, all, "", "of these by the limit on state checks"},
    {"stops_ptc_evaluations", &R::stops_ptc_evaluations, exact, all, "", "of these by the limit on evaluations of the termination condition"},
    {"stops_iterations", &R::stops_iterations, exact, all, "", "of these by the limit on iterations"},
    {"stops_wall_clock", &R::stops_wall_clock, exact, all, "", "of these by the limit on wall-clock time"},
    {"stops_first_solution", &R::stops_first_solution, exact, all, "", "solves of anytime planners that were told to stop at the first solution"},
    {"map_points", &R::map_points, exact, all, "", "points of the map at the end"},
    {"map_obstacles", &R::map_obstacles, exact, all, "", "obstacles of the map at the end"},
    {"modes", &R::modes, exact, all, "", "modes of the planner or states of the executive, in the order of first use"},
    {"state_digest", &R::state_digest, exact, moved, "", "hash over every state of the vehicle"},
    {"tracking_error_rms_m", &R::tracking_error_rms_m, beside, moved, "m", "distance of the centre from the path that it follows, root mean square over the scans that find it following one"},
    {"tracking_error_max_m", &R::tracking_error_max_m, beside, moved, "m", "largest distance of the centre from the path that it follows, over the same scans"},
    {"energy_j", &R::energy_j, beside, moved, "J", "mechanical energy that the actuators gave off until the verdict; none for a model without them"},
    {"settling_s", &R::settling_s, beside, all, "s", "of the vehicle under its regulator, flown apart without a planner: from rest to a point 5 m ahead, until within 5 cm of it for good; absent if never"},
    {"overshoot_m", &R::overshoot_m, beside, all, "m", "how far that goes beyond the point"},
    {"stopping_distance_m", &R::stopping_distance_m, beside, all, "m", "of the vehicle under its regulator, flown apart without a planner: from its largest speed until it stands"},
    {"mapping_time_us_mean", &R::mapping_time_us_mean, measured, moved, "\u00b5s", "mean time of the map per scan"},
    {"mapping_time_us_p99", &R::mapping_time_us_p99, measured, moved, "\u00b5s", "99th percentile of the time of the map per scan"},
    {"planning_time_us_mean", &R::planning_time_us_mean, measured, moved, "\u00b5s", "mean time of planning per scan"},
    {"planning_time_us_p99", &R::planning_time_us_p99, measured, moved, "\u00b5s", "99th percentile of the time of planning per scan"},
    {"step_time_us_mean", &R::step_time_us_mean, measured, moved, "\u00b5s", "mean time of a step: sense, map, plan, navigate, regulate, integrate"},
    {"step_time_us_p99", &R::step_time_us_p99, measured, moved, "\u00b5s", "99th percentile of the time of a step"},
    {"cpu_time_s", &R::cpu_time_s, measured, all, "s", "CPU time of the trial's process"},
    {"memory_max_mb", &R::memory_max_mb, measured, all, "MB", "most memory of the trial's process beyond what it inherited"},
    // clang-format on
};

}  // namespace

std::string_view words(TrialSet trials) {
  switch (trials) {
    case TrialSet::all:
      return "all trials";
    case TrialSet::moved:
      return "trials that moved";
    case TrialSet::goal_reached:
      break;
  }
  return "trials that reached the goal";
}

std::span<const RecordColumn> record_columns() { return kColumns; }

const RecordColumn& column_of(RecordMember member) {
  const auto found = std::find_if(std::begin(kColumns), std::end(kColumns),
                                  [&](const RecordColumn& c) { return c.member == member; });
  if (found != std::end(kColumns)) return *found;
  std::fputs("voronaut: a member of RunRecord is not in the list of columns\n", stderr);
  std::abort();
}

std::string cell_text(double value) {
  if (std::isnan(value)) return {};
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value == 0.0 ? 0.0 : value).ptr;
  return {text, end};
}

std::string cell_text(const RunRecord& record, const RecordColumn& column) {
  return std::visit(
      [&](auto member) -> std::string {
        const auto& value = record.*member;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, Outcome>) {
          return std::string(to_string(value));
        } else if constexpr (std::is_same_v<Value, std::int64_t>) {
          return std::to_string(value);
        } else if constexpr (std::is_same_v<Value, double>) {
          return cell_text(value);
        } else {
          return value;
        }
      },
      column.member);
}

}  // namespace voronaut
