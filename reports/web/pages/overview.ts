// Who arrives, how well, and who beats whom.
import { groupName, plannerCell, statisticCell } from "../elements/cells";
import { byName, byVehicle, kReached, PlannerPairing, PlannerSummary, Report, Statistic, vehicleOf } from "../data/data";
import { el, nameOf } from "../elements/dom";
import { outcomeText } from "../elements/outcome_text";
import { pairingSection } from "./pairings";
import { Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { Column, table } from "../elements/table";

// Those of which the table has no share.
function otherOutcomes(summary: PlannerSummary, shown: Statistic[]): HTMLElement {
  const shares = new Set(shown.map((s) => s.name));
  const texts = Object.entries(summary.outcomes)
    .filter(([name, count]) => count > 0 && !shares.has(`${name}_share`))
    .sort((a, b) => b[1] - a[1])
    .map(([name, count], i) => el("span", {}, i > 0 && ", ", outcomeText(name, count)));
  return el("span", {}, ...(texts.length > 0 ? texts : ["none"]));
}

// Planners down, scenario groups across: the answer in ten seconds.
function arrivalMatrix(
  rows: PlannerSummary[], reached: Statistic, vehicle: string, palette: Palette
): HTMLElement {
  const groups = [...new Set(rows.map(groupName))].sort(byName);
  const planners = [...new Set(rows.map((r) => r.planner))].sort(byName);
  const at = new Map(rows.map((r) => [JSON.stringify([r.planner, groupName(r)]), r]));
  const find = (planner: string, group: string): PlannerSummary | undefined =>
    at.get(JSON.stringify([planner, group]));
  const columns: Column<string>[] = [
    { heading: "planner", text: true, cell: (p) => plannerCell(p, palette), order: (p) => p },
    ...groups.map((group): Column<string> => ({
      heading: group,
      cell: (p) => {
        const row = find(p, group);
        return row ? statisticCell(reached, row.statistics[kReached], row.n) : "\u2013";
      },
      order: (p) => find(p, group)?.statistics[kReached].value ?? NaN,
    })),
  ];
  return table(`Share of trials that reached the goal: ${vehicle}`, columns, planners,
    (p) => palette.className(p));
}

function detailTable(
  rows: PlannerSummary[], statistics: Statistic[], manyVehicles: boolean, palette: Palette
): HTMLElement {
  const shown = statistics.filter((s) => s.in_table && rows.some((r) => r.statistics[s.name].n > 0));
  const column = (s: Statistic): Column<PlannerSummary> => ({
    heading: s.heading, title: s.about,
    cell: (r) => statisticCell(s, r.statistics[s.name], r.n),
    order: (r) => r.statistics[s.name].value ?? NaN,
  });
  const columns: Column<PlannerSummary>[] = [
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette),
      order: (r) => r.planner },
    { heading: "scenarios", text: true, cell: (r) => nameOf(groupName(r)), order: groupName },
    { heading: "n", cell: (r) => String(r.n), order: (r) => r.n, title: "trials, failures included" },
    { heading: "rank", cell: (r) => String(r.rank), order: (r) => r.rank,
      title: "1 + planners of the group that are significantly better on the same worlds: they reach the goal more " +
        "often or, where that is undecided, by the shorter path more often; equal as a rule where the data cannot tell" },
    ...shown.filter((s) => s.rate).map(column),
    { heading: "ended otherwise", text: true, cell: (r) => otherOutcomes(r, shown) },
    ...shown.filter((s) => !s.rate).map(column),
  ];
  if (manyVehicles) {
    columns.splice(1, 0, { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)),
      order: vehicleOf });
  }
  return table("Everything in numbers (95 % intervals: Wilson's of a share, else bootstrapped)", columns, rows,
    (r) => palette.className(r.planner));
}

export function overview(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const keep = (key: PlannerSummary | PlannerPairing): boolean =>
    (!filter.vehicle || vehicleOf(key) === filter.vehicle) &&
    (!filter.group || key.scenario_group === filter.group);
  const rows = [...report.summary.groups, ...report.summary.totals]
    .filter((r) => keep(r) && filter.planners.has(r.planner))
    .sort((a, b) => Number(a.all_scenarios) - Number(b.all_scenarios) ||
      byName(a.scenario_group, b.scenario_group) || byVehicle(a, b) || byName(a.planner, b.planner));
  const { statistics } = report.summary;
  const reached = statistics.find((s) => s.name === kReached) as Statistic;
  const manyVehicles = report.vehicles.length > 1 && !filter.vehicle;
  const matrices = report.vehicles.filter((v) => !filter.vehicle || v === filter.vehicle)
    .map((vehicle) => arrivalMatrix(rows.filter((r) => vehicleOf(r) === vehicle), reached, vehicle,
      palette));
  return el("div", {},
    report.trials.length < report.stored_trials && el("p", { class: "note" },
      `The tables below are over all ${report.stored_trials} trials; what is drawn of single trials is over ` +
      `${report.trials.length} of them, those of the lowest repetitions. The others are in the results store.`),
    el("div", { class: "beside" }, ...matrices),
    detailTable(rows, statistics, manyVehicles, palette), pairingSection(report, palette, filter, keep));
}
