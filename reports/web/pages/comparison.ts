// This run against another one: what changed, trial by trial of the same scenario and repetition.
import { groupName, plannerCell, rateCell } from "../elements/cells";
import { byName, Change, OutcomeChange, PlannerChange, Report, Statistic, vehicleOf } from "../data/data";
import { el, fixed, nameOf } from "../elements/dom";
import { replayLink } from "../elements/links";
import { outcomeText } from "../elements/outcome_text";
import { Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { Column, table } from "../elements/table";
import { hasTrace } from "../data/trace";

function signed(value: number | null, decimals: number): string {
  const text = fixed(value === null ? null : 100 * value, decimals);
  return value !== null && value > 0 ? `+${text}` : text;
}

function changeCell(change: Change, statistic: Statistic): HTMLElement {
  const word = change.verdict;
  const kind = word === "better" ? "good" : word === "worse" ? "bad" : "";
  const unit = statistic.rate ? "" : "%";
  return el("span", { class: kind, title: change.test && `${change.test}, p = ${fixed(change.p, 4)}, ` +
    `corrected ${fixed(change.p_holm, 4)}` }, change.n === 0 ? "\u2013" : `${signed(change.value, 1)} ${unit}`,
    word && el("b", {}, ` ${word}`),
    change.n > 0 && el("small", {}, change.interval[0] === null ? `${change.test && "too few for an interval, "}over ${change.n}`
      : `[${signed(change.interval[0], 1)}, ${signed(change.interval[1], 1)}] over ${change.n}`));
}

function changeTable(rows: PlannerChange[], statistics: Statistic[], palette: Palette): HTMLElement {
  const column = (s: Statistic): Column<PlannerChange> => ({
    heading: s.rate ? `${s.label},\npoints` : s.label,
    title: s.rate ? "change in percentage points, over all pairs"
      : `median change of pairs that both have it; ${s.about}`,
    cell: (r) => changeCell(r.changes[s.name], s),
    order: (r) => r.changes[s.name].value ?? NaN,
  });
  const compared = statistics.filter((s) => s.in_comparison);
  return table("What changed, with 95 % intervals over the pairs", [
    { heading: "scenarios", text: true, cell: (r) => nameOf(groupName(r)), order: groupName },
    { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)), order: vehicleOf },
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette), order: (r) => r.planner },
    { heading: "pairs", cell: (r) => String(r.n), order: (r) => r.n },
    { heading: "goal reached\nthere", cell: (r) => rateCell(r.reached_before),
      order: (r) => r.reached_before.value ?? NaN },
    { heading: "goal reached\nhere", cell: (r) => rateCell(r.reached_now),
      order: (r) => r.reached_now.value ?? NaN },
    ...compared.filter((s) => s.rate).map(column),
    { heading: "gained,\nlost", cell: (r) => `+${r.gained}, \u2212${r.lost}`, order: (r) => r.gained - r.lost },
    ...compared.filter((s) => !s.rate).map(column),
  ], rows, (r) => palette.className(r.planner));
}

function outcomeTable(report: Report, rows: OutcomeChange[], palette: Palette): HTMLElement {
  return table(`${rows.length} trials end differently`, [
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette), order: (r) => r.planner },
    { heading: "scenario", text: true, cell: (r) => nameOf(r.scenario), order: (r) => r.scenario },
    { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)), order: vehicleOf },
    { heading: "repetition", cell: (r) => String(r.repetition), order: (r) => r.repetition },
    { heading: "there", text: true, cell: (r) => outcomeText(r.outcome_before), order: (r) => r.outcome_before },
    { heading: "here", text: true, cell: (r) => outcomeText(r.outcome_now), order: (r) => r.outcome_now },
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
      "worse where its 95 % interval leaves zero out and p, corrected after Holm over the table, is below 5 %.",
      alone > 0 && ` ${other.only_here} trials here and ${other.only_there} there have no partner.`),
    changeTable(other.changes.filter((r) => keep(r) && (!filter.group || r.scenario_group === filter.group))
      .sort((a, b) => byName(groupName(a), groupName(b)) || byName(a.planner, b.planner)),
      report.summary.statistics, palette),
    other.ended_differently > other.outcomes.length && el("p", { class: "note" },
      `${other.ended_differently} trials end differently; the table is of ${other.outcomes.length} of them, those of ` +
      "the lowest repetitions."),
    outcomeTable(report, other.outcomes.filter(keep), palette));
}
