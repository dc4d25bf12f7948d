// Who arrives, how well, and who beats whom.
import { estimateCell, groupName, plannerCell, rateCell } from "../elements/cells";
import { byName, byVehicle, Estimate, PlannerPairing, PlannerSummary, Report, vehicleOf } from "../data/data";
import { el, fixed, nameOf, percent } from "../elements/dom";
import { pairingSection } from "./pairings";
import { outcomeSign, outcomeWords, Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { Column, table } from "../elements/table";

function otherOutcomes(summary: PlannerSummary): HTMLElement {
  const texts = Object.entries(summary.outcomes)
    .filter(([name, count]) => count > 0 && name !== "goal_reached" && name !== "collision")
    .sort((a, b) => b[1] - a[1])
    .map(([name, count]) => `${outcomeSign(name)} ${count} ${outcomeWords(name)}`);
  return el("span", {}, texts.length > 0 ? texts.join(", ") : "none");
}

function countCell(count: number, row: PlannerSummary): HTMLElement {
  const [low, high] = row.collisions.interval;
  return el("span", {}, String(count), count > 0 && el("small", {},
    `${percent(row.collisions.value)} [${fixed(100 * (low ?? NaN), 0)}, ${fixed(100 * (high ?? NaN), 0)}]`));
}

// Planners down, scenario groups across: the answer in ten seconds.
function arrivalMatrix(rows: PlannerSummary[], vehicle: string, palette: Palette): HTMLElement {
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
        return row ? rateCell(row.success) : "\u2013";
      },
      order: (p) => find(p, group)?.success.value ?? NaN,
    })),
  ];
  return table(`Share of trials that reached the goal: ${vehicle}`, columns, planners,
    (p) => palette.className(p));
}

function detailTable(rows: PlannerSummary[], manyVehicles: boolean, palette: Palette): HTMLElement {
  const estimate = (heading: string, title: string, key: keyof PlannerSummary, decimals: number):
      Column<PlannerSummary> => ({
    heading, title,
    cell: (r) => estimateCell(r[key] as Estimate, decimals, r.n),
    order: (r) => (r[key] as Estimate).value ?? NaN,
  });
  const columns: Column<PlannerSummary>[] = [
    { heading: "scenarios", text: true, cell: (r) => nameOf(groupName(r)), order: groupName },
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette),
      order: (r) => r.planner },
    { heading: "n", cell: (r) => String(r.n), order: (r) => r.n, title: "trials, failures included" },
    { heading: "goal reached", cell: (r) => rateCell(r.success),
      order: (r) => r.success.value ?? NaN, title: "of all n; Wilson 95 % interval" },
    { heading: "collisions", cell: (r) => countCell(r.collisions.successes, r),
      order: (r) => r.collisions.value ?? NaN, title: "of all n; Wilson 95 % interval" },
    { heading: "ended otherwise", text: true, cell: otherOutcomes,
      order: (r) => r.n - r.success.successes - r.collisions.successes },
    estimate("path ratio\nmedian", "flown / shortest, of trials that reached the goal",
      "path_ratio_median", 3),
    estimate("path ratio\n95th percentile", "flown / shortest, of trials that reached the goal",
      "path_ratio_p95", 3),
    estimate("SPL\nmean", "success weighted by path length; a failure counts 0", "spl_mean", 3),
    estimate("time to goal\nmedian, s", "of trials that reached the goal", "duration_median_s", 1),
    { heading: "clearance\nsmallest, m", title: "centre to the nearest surface, over all trials",
      cell: (r) => el("span", {}, fixed(r.clearance_min_m, 2),
        el("small", {}, `median ${fixed(r.clearance_median_m.value, 2)}`)),
      order: (r) => r.clearance_min_m ?? NaN },
    estimate("mean speed\nmedian, m/s", "of the trials' means", "speed_mean_median_m_s", 2),
    estimate("replans\nmedian", "per trial", "replans_median", 0),
    estimate("state checks\nmedian", "per trial", "state_checks_median", 0),
    estimate("planning\n\u00B5s per scan", "median of the trials' means; measured, not deterministic",
      "planning_time_us_median", 1),
    estimate("whole step\n\u00B5s", "median of the trials' means; measured, not deterministic",
      "step_time_us_median", 0),
  ];
  if (manyVehicles) {
    columns.splice(1, 0, { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)),
      order: vehicleOf });
  }
  return table("Everything in numbers (medians with bootstrap 95 % intervals)", columns, rows,
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
  const manyVehicles = report.vehicles.length > 1 && !filter.vehicle;
  const matrices = report.vehicles.filter((v) => !filter.vehicle || v === filter.vehicle)
    .map((vehicle) => arrivalMatrix(rows.filter((r) => vehicleOf(r) === vehicle), vehicle, palette));
  return el("div", {}, el("div", { class: "beside" }, ...matrices),
    detailTable(rows, manyVehicles, palette), pairingSection(report, palette, filter, keep));
}
