// A run of static planning (benchmarks/static_planning): nobody flew, each trial is one search within a
// budget. The tables of words are about flights; here they are put for such a run.
import type { OutcomeEntry } from "./outcomes";
import type { Statistic, Trial } from "./data";

interface Words {
  columns: Record<string, { unit: string; about: string }>;
  outcomes: OutcomeEntry[];
  summary: { statistics: Statistic[] };
}

export function isPlannedOnly(trials: Trial[]): boolean {
  return trials.some((t) => !Number.isNaN(t.planning_time_us_mean)) &&
    trials.every((t) => Number.isNaN(t.duration_s) && Number.isNaN(t.speed_mean_m_s));
}

export function putForPlanning(words: Words): void {
  for (const entry of words.outcomes) {
    if (entry.name !== "timeout") continue;
    Object.assign(entry, { words: "budget spent", sign: "B",
      meaning: "the budget of the search was spent before it had found a path" });
  }
  for (const s of words.summary.statistics) {
    if (s.name === "replans_median") s.in_table = false;
    if (s.name === "planning_time_us_median") s.about = "median over the trials: time of the search; measured";
  }
  if (words.columns.planning_time_us_mean) words.columns.planning_time_us_mean.about = "time of the search";
}
