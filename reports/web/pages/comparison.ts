// This run against another one: what changed, trial by trial of the same scenario and repetition.
import { groupName, plannerCell } from "../elements/cells";
import { byName, Estimate, kGoal, OutcomeChange, PlannerChange, Rate, Report, vehicleOf } from "../data/data";
import { el, fixed, nameOf, percent } from "../elements/dom";
import { replayLink } from "../elements/links";
import { outcomeSign, outcomeWords, Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { Column, table } from "../elements/table";
import { hasTrace } from "../data/trace";

function signed(value: number | null, decimals: number): string {
  const text = fixed(value === null ? null : 100 * value, decimals);
  return value !== null && value > 0 ? `+${text}` : text;
}

// Below six pairs no outcome of a two-sided sign test falls under 5 %: no word is said then.
const kFewestPairs = 6;

// Whether an interval leaves zero out, and on which side.
function verdict(change: Estimate, moreIsBetter: boolean): "better" | "worse" | "" {
  const [low, high] = change.interval;
  if (change.n < kFewestPairs || low === null || high === null || (low <= 0 && high >= 0)) return "";
  return (low > 0) === moreIsBetter ? "better" : "worse";
}

function changeCell(change: Estimate, moreIsBetter: boolean, unit: string): HTMLElement {
  const word = verdict(change, moreIsBetter);
  const kind = word === "better" ? "good" : word === "worse" ? "bad" : "";
  return el("span", { class: kind }, change.n === 0 ? "\u2013" : `${signed(change.value, 1)} ${unit}`,
    word && el("b", {}, ` ${word}`),
    change.interval[0] !== null && el("small", {}, `[${signed(change.interval[0], 1)}, ` +
      `${signed(change.interval[1], 1)}] over ${change.n}`));
}

function rateText(rate: Rate): HTMLElement {
  return el("span", {}, percent(rate.value), el("small", {}, `${rate.successes}/${rate.n}, ` +
    `[${fixed(100 * (rate.interval[0] ?? NaN), 0)}, ${fixed(100 * (rate.interval[1] ?? NaN), 0)}]`));
}

function changeTable(rows: PlannerChange[], palette: Palette): HTMLElement {
  const change = (heading: string, key: keyof PlannerChange, moreIsBetter: boolean, unit: string,
                  title: string): Column<PlannerChange> => ({
    heading, title,
    cell: (r) => changeCell(r[key] as Estimate, moreIsBetter, unit),
    order: (r) => (r[key] as Estimate).value ?? NaN,
  });
  return table("What changed, with 95 % intervals over the pairs", [
    { heading: "scenarios", text: true, cell: (r) => nameOf(groupName(r)), order: groupName },
    { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)), order: vehicleOf },
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette), order: (r) => r.planner },
    { heading: "pairs", cell: (r) => String(r.n), order: (r) => r.n },
    { heading: "goal reached\nthere", cell: (r) => rateText(r.reached_before),
      order: (r) => r.reached_before.value ?? NaN },
    { heading: "goal reached\nhere", cell: (r) => rateText(r.reached_now),
      order: (r) => r.reached_now.value ?? NaN },
    change("change,\npoints", "success_change", true, "", "percentage points, over all pairs"),
    { heading: "gained,\nlost", cell: (r) => `+${r.gained}, \u2212${r.lost}`, order: (r) => r.gained - r.lost },
    change("path ratio", "path_ratio_change", false, "%", "median change of pairs that both reached the goal"),
    change("time to goal", "duration_change", false, "%", "median change of pairs that both reached the goal"),
    change("state checks", "state_checks_change", false, "%", "median change of all pairs"),
    change("planning time", "planning_time_change", false, "%", "median change of all pairs; measured"),
  ], rows, (r) => palette.className(r.planner));
}

function outcomeTable(report: Report, rows: OutcomeChange[], palette: Palette): HTMLElement {
  const words = (outcome: string): HTMLElement => el("span", { class: outcome === kGoal ? "good" : "bad" },
    `${outcomeSign(outcome)} ${outcomeWords(outcome)}`);
  return table(`${rows.length} trials end differently`, [
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette), order: (r) => r.planner },
    { heading: "scenario", text: true, cell: (r) => nameOf(r.scenario), order: (r) => r.scenario },
    { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)), order: vehicleOf },
    { heading: "repetition", cell: (r) => String(r.repetition), order: (r) => r.repetition },
    { heading: "there", text: true, cell: (r) => words(r.outcome_before), order: (r) => r.outcome_before },
    { heading: "here", text: true, cell: (r) => words(r.outcome_now), order: (r) => r.outcome_now },
    { heading: "reason here", text: true, wrap: true, cell: (r) => el("bdi", {}, r.reason_now) },
    { heading: "replay", text: true, cell: (r) => hasTrace(report, r.trial_id)
      ? el("a", { href: replayLink([r.trial_id]) }, "watch") : "\u2013" },
  ], rows, (r) => palette.className(r.planner));
}

export function comparisonSection(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const other = report.comparison;
  if (other === null) return el("p", { class: "soft" }, "No other run was given.");
  const keep = (row: { planner: string; vehicle: string; regulator: string }): boolean =>
    filter.planners.has(row.planner) && (!filter.vehicle || vehicleOf(row) === filter.vehicle);
  const alone = other.only_here + other.only_there;
  return el("div", {},
    el("p", {}, "Here: this run. There: ", el("b", {}, el("bdi", {}, other.title)),
      other.commit && `, commit ${other.commit.slice(0, 12)}`,
      ". Trials are paired by scenario, vehicle, planner and repetition; a change is called better or " +
      `worse where its 95 % interval leaves zero out, from ${kFewestPairs} pairs on.`,
      alone > 0 && ` ${other.only_here} trials here and ${other.only_there} there have no partner.`),
    changeTable(other.changes.filter((r) => keep(r) && (!filter.group || r.scenario_group === filter.group))
      .sort((a, b) => byName(groupName(a), groupName(b)) || byName(a.planner, b.planner)), palette),
    outcomeTable(report, other.outcomes.filter(keep), palette));
}
