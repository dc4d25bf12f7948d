#include "voronaut/benchmarks/episode/flown_trial.h"

#include <cmath>

#include "voronaut/benchmarks/episode/barn_challenge.h"
#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/trial/ompl_seed.h"
#include "voronaut/reports/summary/estimate.h"

namespace voronaut {

namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

void add_metrics(RunRecord& record, const EpisodeLog& log, const Scenario& scenario,
                 const Model& model) {
  const double arrival_or_end_s = log.end_s;
  const auto last = static_cast<std::size_t>(
      std::count_if(log.ticks.begin(), log.ticks.end(),
                    [&](const Tick& t) { return t.t_s <= arrival_or_end_s + 1e-9; }));
  const std::span<const Tick> flown(log.ticks.data(), last);
  record.duration_s = arrival_or_end_s;
  add_path(record, flown, scenario);
  record.clearance_smallest_m = clearance_smallest_m(log.ticks);  // while it holds at the goal too
  record.body_clearance_smallest_m = log.body_clearance_smallest_m;
  record.speed_mean_m_s = speed_mean_m_s(flown, log.departure_s);
  record.speed_max_m_s = speed_max_m_s(flown);
  if (scenario.barn_length_m > 0) add_barn(record, flown, scenario.barn_length_m);
  record.state_digest = state_digest(log.ticks);
  const TrackingError tracking = tracking_error(log.scans);
  record.tracking_error_rms_m = tracking.rms_m;
  record.tracking_error_max_m = tracking.max_m;
  record.energy_j = energy_j(flown, model);
}

void add_times(RunRecord& record, const EpisodeLog& log) {
  record.mapping_time_us_mean = mean(log.mapping.samples_us());
  record.mapping_time_us_p99 = quantile(log.mapping.samples_us(), 0.99);
  record.planning_time_us_mean = mean(log.planning.samples_us());
  record.planning_time_us_p99 = quantile(log.planning.samples_us(), 0.99);
  record.step_time_us_mean = mean(log.step.samples_us());
  record.step_time_us_p99 = quantile(log.step.samples_us(), 0.99);
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
  add_metrics(result.record, log, spec.scenario, *flight.model);
  add_times(result.record, log);
  if (keep_trace) result.trace = trace_of(spec, log, flight.navigator.known());
  return result;
}

}  // namespace voronaut
