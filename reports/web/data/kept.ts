// What the drawings are of, where not every flight is kept: a choice that nobody made knowingly must not
// pass for the whole.
import { Report, Trial, vehicleOf } from "./data";
import { failed } from "./outcomes";
import { hasTrace } from "./trace";

function ofThem(kept: Trial[]): string {
  return kept.length > 0 && kept.every((t) => failed(t.outcome)) ? ", failures only" : "";
}

// "3 of 12 flights are kept, failures only"; empty where all are. Of the run.
export function keptOfRun(report: Report): string {
  if (report.stored_traces >= report.stored_trials) return "";
  const kept = report.trials.filter((t) => hasTrace(report, t.trial_id));
  const what = report.plannedOnly ? "trials" : "flights";
  return `${report.stored_traces} of ${report.stored_trials} ${what} are kept${ofThem(kept)}`;
}

// "arrived 11 of 12": of one planner, with one vehicle, in one scenario; empty of a single flight.
export function arrivedOf(report: Report, trial: Trial): string {
  const like = report.trials.filter((t) => t.scenario === trial.scenario && t.planner === trial.planner &&
    vehicleOf(t) === vehicleOf(trial));
  return like.length < 2 ? "" : `arrived ${like.filter((t) => !failed(t.outcome)).length} of ${like.length}`;
}
