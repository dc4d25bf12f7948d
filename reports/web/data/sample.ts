import type { Report, Trial } from "./data";
import { vehicleOf } from "./data";

// The trials of one planner under one selection.
export interface Sample {
  planner: string;
  trials: Trial[];
}

export type Value = (trial: Trial) => number;

export interface Filter {
  group: string;    // "" is all
  vehicle: string;  // "" is all
  planners: Set<string>;  // those that are shown
}

export function keeps(filter: Filter, trial: Trial): boolean {
  return (!filter.group || trial.scenario_group === filter.group) &&
    (!filter.vehicle || vehicleOf(trial) === filter.vehicle) && filter.planners.has(trial.planner);
}

export function samplesOf(report: Report, filter: Filter): Sample[] {
  const byPlanner = new Map<string, Trial[]>(report.planners.map((p) => [p, []]));
  for (const trial of report.trials) {
    if (keeps(filter, trial)) byPlanner.get(trial.planner)?.push(trial);
  }
  return [...byPlanner].map(([planner, trials]) => ({ planner, trials }))
    .filter((s) => s.trials.length > 0);
}
