#include "voronaut/benchmarks/episode/flown_trial.h"

#include <cmath>


#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/trial/ompl_seed.h"

namespace voronaut {

namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

void add_metrics(RunRecord& record, const EpisodeLog& log, const Vec2& goal_world) {
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
    const double left_m = (flown.back().state.p_world.head<2>() - goal_world).norm();
    record.path_ratio = (record.path_length_m + left_m) / record.shortest_length_m;
  }
  record.spl = spl(success, record.shortest_length_m, record.path_length_m);
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

TrialResult run_flown_trial(const TrialSpec& spec, const PlannerCatalog& planners,
                            bool keep_trace) {
  seed_ompl(spec.planner_seed);

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
  add_metrics(result.record, log, spec.scenario.goal_world);
  add_times(result.record, log);
  if (keep_trace) result.trace = trace_of(spec, log, flight.navigator.known());
  return result;
}

}  // namespace voronaut
