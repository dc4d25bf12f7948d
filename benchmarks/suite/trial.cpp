#include "voronaut/benchmarks/suite/trial.h"

#include <cmath>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/known/known_trial.h"

namespace voronaut {

namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

void add_metrics(RunRecord& record, const EpisodeLog& log, const Scenario& scenario) {
  const double arrival_or_end_s = log.end_s;
  const auto last = static_cast<std::size_t>(
      std::count_if(log.ticks.begin(), log.ticks.end(),
                    [&](const Tick& t) { return t.t_s <= arrival_or_end_s + 1e-9; }));
  const std::span<const Tick> flown(log.ticks.data(), last);
  const bool success = record.outcome == Outcome::goal_reached;
  record.duration_s = arrival_or_end_s;
  record.path_length_m = path_length_m(flown);
  if (success) {
    // The flight ends at the goal's tolerance, the reference at the goal: the rest of the way
    // counts.
    const double left_m = (flown.back().state.p_world.head<2>() - scenario.goal_world).norm();
    record.path_ratio = path_ratio(record.path_length_m + left_m, record.shortest_length_m,
                                   scenario.goal_tolerance_m);
  }
  record.spl =
      spl(success, record.shortest_length_m, record.path_length_m, scenario.goal_tolerance_m);
  record.clearance_min_m = clearance_min_m(log.ticks);
  record.clearance_mean_m = clearance_mean_m(flown);
  record.speed_mean_m_s = speed_mean_m_s(flown, log.departure_s);
  record.speed_max_m_s = speed_max_m_s(flown);
  record.end_x_m = flown.back().state.p_world.x();
  record.end_y_m = flown.back().state.p_world.y();
  record.state_digest = state_digest(log.ticks);
}

void add_times(RunRecord& record, const EpisodeLog& log) {
  record.mapping_time_us_mean = mean(log.mapping.samples_us());
  record.mapping_time_us_p99 = percentile(log.mapping.samples_us(), 99);
  record.planning_time_us_mean = mean(log.planning.samples_us());
  record.planning_time_us_p99 = percentile(log.planning.samples_us(), 99);
  record.step_time_us_mean = mean(log.step.samples_us());
  record.step_time_us_p99 = percentile(log.step.samples_us(), 99);
}

}  // namespace

void add_solve_ends(RunRecord& record, const std::array<std::int64_t, kSolveEnds>& ends) {
  const auto count = [&](SolveEnd end) { return ends[static_cast<std::size_t>(end)]; };
  record.stops_first_solution = count(SolveEnd::first_solution);
  record.stops_state_checks = count(SolveEnd::state_checks);
  record.stops_ptc_evaluations = count(SolveEnd::ptc_evaluations);
  record.stops_iterations = count(SolveEnd::iterations);
  record.stops_wall_clock = count(SolveEnd::wall_clock);
  record.budget_stops = record.stops_state_checks + record.stops_ptc_evaluations +
                        record.stops_iterations + record.stops_wall_clock;
}

RunRecord record_before_flight(const TrialSpec& spec) {
  RunRecord record;
  record.trial_id = spec.trial_id;
  record.suite = spec.suite;
  record.scenario = spec.scenario.name;
  record.scenario_group = spec.scenario.group;
  record.world_id = spec.world_id;
  record.vehicle = spec.vehicle.name;
  record.regulator = spec.regulator_name;
  record.planner = spec.planner.label;
  record.repetition = spec.repetition;
  record.seed = static_cast<std::int64_t>(spec.planner_seed);
  record.shortest_length_m = spec.shortest_length_m;
  record.shortest_at_clearance_m = spec.shortest_at_clearance_m;
  return record;
}

TrialResult run_trial(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_trace) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  if (spec.kind == TrialKind::known) return run_known_trial(spec, planners, keep_trace);
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(spec.planner_seed % 0x7fffffffU) + 1);

  TrialResult result{record_before_flight(spec), std::nullopt};
  Flight flight(spec, planners, keep_trace);
  if (flight.referee.contact_at_start()) {
    result.record.outcome = Outcome::invalid;
    result.record.reason = "the body touches an obstacle at the start";
    return result;
  }
  const EpisodeLog log = fly(flight);
  result.record.outcome = log.verdict.outcome;
  result.record.reason = log.verdict.reason;
  result.record.replans = log.replans;
  result.record.modes = join(log.modes);
  result.record.state_checks = static_cast<std::int64_t>(flight.navigator.state_checks());
  add_solve_ends(result.record, log.solve_ends);
  result.record.map_points = static_cast<std::int64_t>(flight.navigator.known().points().size());
  result.record.map_obstacles = static_cast<std::int64_t>(flight.navigator.known().cluster_count());
  add_metrics(result.record, log, spec.scenario);
  add_times(result.record, log);
  if (keep_trace) result.trace = trace_of(spec, log, flight.navigator.known());
  return result;
}

}  // namespace voronaut
