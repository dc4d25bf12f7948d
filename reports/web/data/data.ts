// What the page was given (reports/page/report_data.h).

import type { MappedLog } from "./mapped_log";
import type { Micro } from "./micro_results";
import { OutcomeEntry, useOutcomes } from "./outcomes";
import { isPlannedOnly, putForPlanning } from "./planned_only";

export interface MappingData {
  micro: Micro;
  logs: MappedLog[];
}

export interface Estimate {
  value: number | null;
  interval: [number | null, number | null];
  n: number;
  too_few?: number[];  // the values, ascending, where they are too few for the interval
}

// A line of the table of statistics (reports/summary/statistics.h).
export interface Statistic {
  name: string;
  column: string;   // of a record that it is over, if it is one
  label: string;
  heading: string;  // label, line break, estimator and unit
  about: string;
  unit: string;
  rate: boolean;
  better: "more" | "less" | "";
  digits: number;       // of a rate those of its percentage
  of_reached: boolean;  // over the trials that reached the goal, else over all that have a value
  question: string;     // title of the plot of its values, if there is one
  logarithmic: boolean;
  in_table: boolean;
  in_sweeps: boolean;
  in_comparison: boolean;
}

export interface Rate extends Estimate {
  successes: number;
}

export interface GroupKey {
  scenario_group: string;
  all_scenarios: boolean;
  vehicle: string;
  regulator: string;
}

export interface PlannerSummary extends GroupKey {
  planner: string;
  n: number;
  rank: number;  // 1 + planners of the group that are significantly better
  outcomes: Record<string, number>;
  statistics: Record<string, Estimate>;  // by name; a rate is a Rate
}

export interface PlannerPairing extends GroupKey {
  planner_a: string;
  planner_b: string;
  n: number;
  wins_a: number;
  ties: number;
  wins_b: number;
  win_share_a: Rate;
}

export interface Change extends Estimate {
  p: number | null;
  p_holm: number | null;  // corrected over the whole comparison
  test: string;
  verdict: "better" | "worse" | "";
  repetitions_needed: number | null;
}

// One planner in one group, here against there: trials paired by scenario, repetition and vehicle.
export interface PlannerChange extends GroupKey {
  planner: string;
  n: number;
  reached_before: Rate;
  reached_now: Rate;
  gained: number;  // trials that failed there and reach the goal here
  lost: number;    // the other way round
  changes: Record<string, Change>;  // by name of statistic: of a rate the mean, else relative, the median
}

export interface OutcomeChange {
  trial_id: string;  // in this run
  scenario: string;
  vehicle: string;
  regulator: string;
  planner: string;
  repetition: number;
  outcome_before: string;
  outcome_now: string;
  reason_now: string;
}

export interface Comparison {
  title: string;  // of the other run
  commit: string;
  only_here: number;   // trials without a partner
  only_there: number;
  ended_differently: number;  // pairs
  changes: PlannerChange[];
  outcomes: OutcomeChange[];  // of very many those of the lowest repetitions
}

// A row of ours, or what somebody published (no vehicle), over the worlds that all have met.
export interface Standing {
  name: string;
  vehicle: string;
  worlds: number;
  reached: Rate;   // over runs
  collided: Rate;
  score: Estimate; // over the worlds' means, as the time
  time_s: Estimate;
}

// Of our mean score less theirs, paired by world.
export interface Difference {
  planner: string;
  vehicle: string;
  method: string;
  worlds: number;
  score: Estimate;
  p: number | null;
  p_holm: number | null;  // corrected over all differences
}

export interface Published {
  worlds: number;
  standings: Standing[];
  differences: Difference[];
}

export interface World {
  world_id: string;
  bounds: [number, number, number, number];
  circles: [number, number, number][];
  polygons: number[][];
  segments: [number, number, number, number][];
  start: [number, number];
  goal: [number, number];
}

// Texts and integers of a record as strings, other numbers as numbers, NaN where absent.
export interface Trial {
  trial_id: string;
  suite: string;
  scenario: string;
  scenario_group: string;
  world_id: string;
  vehicle: string;
  regulator: string;
  planner: string;
  repetition: string;
  seed: string;
  outcome: string;
  reason: string;
  modes: string;
  duration_s: number;
  path_length_m: number;
  path_ratio: number;
  spl: number;
  clearance_smallest_m: number;
  free_share: number;
  narrowest_passage_m: number;
  speed_mean_m_s: number;
  end_x_m: number;
  end_y_m: number;
  planning_time_us_mean: number;
  step_time_us_mean: number;
  [column: string]: string | number;
}

type TextColumn = { texts: string[]; index: number[] };

interface Payload {
  title: string;
  manifest: unknown;
  columns: Record<string, { unit: string; about: string }>;  // of a trial
  outcomes: OutcomeEntry[];
  summary: { groups: PlannerSummary[]; totals: PlannerSummary[]; pairings: PlannerPairing[];
    statistics: Statistic[] };
  trials: Record<string, TextColumn | (number | null)[]>;
  worlds: World[];
  traces: Record<string, string>;
  stored_traces: number;
  stored_trials: number;
  folder: string;  // as it was named on the command line
  comparison: Comparison | null;
  published: Published | null;
  mapping: MappingData | null;
}

export interface Report extends Omit<Payload, "trials" | "worlds"> {
  trials: Trial[];
  plannedOnly: boolean;  // nobody flew
  worlds: Map<string, World>;
  planners: string[];
  groups: string[];
  vehicles: string[];  // "vehicle" or "vehicle, regulator": what is compared with its like only
}

// The share of trials that reached the goal: the first of the statistics.
export const kReached = "goal_reached_share";

export function vehicleOf(key: { vehicle: string; regulator: string }): string {
  return key.regulator ? `${key.vehicle}, ${key.regulator}` : key.vehicle;
}

// "forest-2" comes before "forest-10".
export function byName(a: string, b: string): number {
  return a.localeCompare(b, "en", { numeric: true });
}

type Flown = { vehicle: string; regulator: string };

export function byVehicle(a: Flown, b: Flown): number {
  return byName(a.vehicle, b.vehicle) || byName(a.regulator, b.regulator);
}

function distinct(values: string[]): string[] {
  return [...new Set(values)].sort(byName);
}

function readTrials(columns: Payload["trials"]): Trial[] {
  const names = Object.keys(columns);
  const ids = columns.trial_id as TextColumn;
  return ids.index.map((_, i) => {
    const trial: Record<string, string | number> = {};
    for (const name of names) {
      const column = columns[name];
      trial[name] = Array.isArray(column) ? (column[i] ?? NaN) : column.texts[column.index[i]];
    }
    return trial as Trial;
  });
}

export function readReport(json: string): Report {
  const payload = JSON.parse(json) as Payload;
  const trials = readTrials(payload.trials);
  const plannedOnly = isPlannedOnly(trials);
  if (plannedOnly) putForPlanning(payload);
  useOutcomes(payload.outcomes);
  return {
    ...payload,
    trials,
    plannedOnly,
    worlds: new Map(payload.worlds.map((w) => [w.world_id, w])),
    planners: distinct(trials.map((t) => t.planner)),
    groups: distinct(trials.map((t) => t.scenario_group)),
    vehicles: [...new Map(trials.map((t) => [vehicleOf(t), t])).entries()]
      .sort(([, a], [, b]) => byVehicle(a, b))
      .map(([name]) => name),
  };
}
