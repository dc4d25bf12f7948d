// Who arrives, how well, and who beats whom.
import { byName, byVehicle, Estimate, PlannerPairing, PlannerSummary, Rate, Report, vehicleOf } from "./data";
import { el, fixed, nameOf, percent, svg } from "./dom";
import { outcomeSign, outcomeWords, Palette } from "./palette";
import { Column, table } from "./table";

export interface Filter {
  group: string;    // "" is all
  vehicle: string;  // "" is all
}

function rateBar(rate: Rate): SVGElement {
  const x = (share: number): number => 2 + 76 * share;
  const bar = svg("svg", { class: "bar", width: 80, height: 12, viewBox: "0 0 80 12",
    "aria-hidden": "true" },
    svg("rect", { class: "rail", x: 2, y: 4, width: 76, height: 4 }));
  if (rate.value !== null) {
    bar.append(svg("rect", { class: "value", x: 2, y: 3, width: 76 * rate.value, height: 6 }));
    const [low, high] = rate.interval;
    bar.append(
      svg("line", { x1: x(low ?? 0), x2: x(high ?? 1), y1: 6, y2: 6 }),
      svg("line", { x1: x(low ?? 0), x2: x(low ?? 0), y1: 3, y2: 9 }),
      svg("line", { x1: x(high ?? 1), x2: x(high ?? 1), y1: 3, y2: 9 }));
  }
  return bar;
}

function rateCell(rate: Rate): HTMLElement {
  return el("span", {}, rateBar(rate), ` ${percent(rate.value)} `,
    el("small", {}, `${rate.successes}/${rate.n}, 95 % [${fixed(100 * (rate.interval[0] ?? NaN), 0)}, ` +
      `${fixed(100 * (rate.interval[1] ?? NaN), 0)}]`));
}

function estimateCell(estimate: Estimate, decimals: number, ofAll: number): HTMLElement {
  const [low, high] = estimate.interval;
  const parts = [];
  if (low !== null) parts.push(`[${fixed(low, decimals)}, ${fixed(high, decimals)}]`);
  if (estimate.n !== ofAll) parts.push(`over ${estimate.n}`);
  return el("span", {}, fixed(estimate.value, decimals),
    parts.length > 0 && el("small", {}, parts.join(" ")));
}

function otherOutcomes(summary: PlannerSummary): HTMLElement {
  const texts = Object.entries(summary.outcomes)
    .filter(([name, count]) => count > 0 && name !== "goal_reached")
    .sort((a, b) => b[1] - a[1])
    .map(([name, count]) => `${outcomeSign(name)} ${count} ${outcomeWords(name)}`);
  return el("span", {}, texts.length > 0 ? texts.join(", ") : "none");
}

function plannerCell(planner: string, palette: Palette): HTMLElement {
  return el("span", {}, palette.swatch(planner), " ", nameOf(planner));
}

function groupName(key: { all_scenarios: boolean; scenario_group: string }): string {
  return key.all_scenarios ? "all scenarios" : key.scenario_group;
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
    { heading: "ended otherwise", text: true, cell: otherOutcomes,
      order: (r) => r.n - r.success.successes },
  ];
  if (manyVehicles) {
    columns.splice(1, 0, { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)),
      order: vehicleOf });
  }
  return table("Everything in numbers (medians with bootstrap 95 % intervals)", columns, rows,
    (r) => palette.className(r.planner));
}

function pairingTable(rows: PlannerPairing[], manyVehicles: boolean): HTMLElement {
  const columns: Column<PlannerPairing>[] = [
    { heading: "scenarios", text: true, cell: (r) => nameOf(groupName(r)), order: groupName },
    { heading: "planner", text: true, cell: (r) => nameOf(r.planner_a), order: (r) => r.planner_a },
    { heading: "against", text: true, cell: (r) => nameOf(r.planner_b), order: (r) => r.planner_b },
    { heading: "n", cell: (r) => String(r.n), order: (r) => r.n },
    { heading: "win", cell: (r) => String(r.wins_a), order: (r) => r.wins_a },
    { heading: "tie", cell: (r) => String(r.ties), order: (r) => r.ties },
    { heading: "loss", cell: (r) => String(r.wins_b), order: (r) => r.wins_b },
    { heading: "won of the decided", cell: (r) => r.win_share_a.n > 0 ? rateCell(r.win_share_a) : "\u2013",
      order: (r) => r.win_share_a.value ?? NaN },
  ];
  if (manyVehicles) {
    columns.splice(1, 0, { heading: "vehicle", text: true, cell: (r) => nameOf(vehicleOf(r)),
      order: vehicleOf });
  }
  return table("Pairwise on the same world and repetition", columns, rows, () => "p7");
}

export function overview(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const all = [...report.summary.groups, ...report.summary.totals];
  const keep = (key: PlannerSummary | PlannerPairing): boolean =>
    (!filter.vehicle || vehicleOf(key) === filter.vehicle) &&
    (!filter.group || key.scenario_group === filter.group);
  const rows = all.filter(keep).sort((a, b) => Number(a.all_scenarios) - Number(b.all_scenarios) ||
    byName(a.scenario_group, b.scenario_group) || byVehicle(a, b) ||
    byName(a.planner, b.planner));
  const manyVehicles = report.vehicles.length > 1 && !filter.vehicle;
  const pairings = report.summary.pairings.filter(keep);
  const matrices = report.vehicles
    .filter((vehicle) => !filter.vehicle || vehicle === filter.vehicle)
    .map((vehicle) => arrivalMatrix(rows.filter((r) => vehicleOf(r) === vehicle), vehicle, palette));
  const widest = pairings.filter((p) => p.all_scenarios || filter.group ||
    !report.summary.totals.some((t) => vehicleOf(t) === vehicleOf(p)));
  const pairedAway = pairings.length - widest.length;
  return el("div", {}, el("div", { class: "beside" }, ...matrices), detailTable(rows, manyVehicles, palette),
    widest.length > 0 && el("details", { open: "" }, el("summary", {}, "Who beats whom"),
      el("p", { class: "note" }, "Reaching the goal beats not reaching it; of two that reached it " +
        "the shorter path wins, unless the path ratios are within 1 %; two failures tie. " +
        (pairedAway > 0 ? "Choose a scenario group to see it alone." : "")),
      pairingTable(widest, manyVehicles)));
}
