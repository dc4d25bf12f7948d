#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

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
  if (spec.scenario.barn_length_m > 0) record.barn_score = 0;  // until it arrives
  record.free_share = spec.free_share;
  record.narrowest_passage_m = spec.narrowest_passage_m;
  record.settling_s = spec.answer.settling_s;
  record.overshoot_m = spec.answer.overshoot_m;
  record.stopping_distance_m = spec.answer.stopping_distance_m;
  return record;
}

}  // namespace voronaut
