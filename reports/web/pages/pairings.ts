// Who beats whom on the same worlds.
import { groupName, plannerCell, rateCell } from "../elements/cells";
import { byName, PlannerPairing, Report, vehicleOf } from "../data/data";
import { el, fixed, kShareDigits, nameOf, percent, svg } from "../elements/dom";
import { Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { Column, table } from "../elements/table";

const kBar_px = 92;

// The pairing as the planner `a` sees it.
interface Duel {
  a: string;
  b: string;
  n: number;
  wins: number;
  ties: number;
  losses: number;
  share: number | null;  // of the decided
  interval: [number | null, number | null];
}

function duelsOf(pairing: PlannerPairing): Duel[] {
  const { value, interval } = pairing.win_share_a;
  const flipped = (v: number | null): number | null => (v === null ? null : 1 - v);
  return [
    { a: pairing.planner_a, b: pairing.planner_b, n: pairing.n, wins: pairing.wins_a,
      ties: pairing.ties, losses: pairing.wins_b, share: value, interval },
    { a: pairing.planner_b, b: pairing.planner_a, n: pairing.n, wins: pairing.wins_b,
      ties: pairing.ties, losses: pairing.wins_a, share: flipped(value),
      interval: [flipped(interval[1]), flipped(interval[0])] },
  ];
}

// Win, tie, loss from left to right.
function duelBar(duel: Duel, palette: Palette): SVGElement {
  const bar = svg("svg", { class: "duel", width: kBar_px, height: 10, viewBox: `0 0 ${kBar_px} 10`,
    "aria-hidden": "true" });
  let x = 0;
  const parts: [number, string][] = [[duel.wins, `win ${palette.className(duel.a)}`],
    [duel.ties, "tie"], [duel.losses, `loss ${palette.className(duel.b)}`]];
  for (const [count, name] of parts) {
    const width = kBar_px * count / Math.max(1, duel.n);
    bar.append(svg("rect", { class: name, x, y: 0, width, height: 10 }));
    x += width;
  }
  return bar;
}

function duelCell(duel: Duel, palette: Palette): HTMLElement {
  const [low, high] = duel.interval;
  return el("span", { "data-tip": `${duel.a} against ${duel.b}, n = ${duel.n}\n${duel.wins} won, ` +
    `${duel.ties} tied, ${duel.losses} lost` },
    duelBar(duel, palette), ` ${duel.wins}\u2013${duel.ties}\u2013${duel.losses}`,
    el("small", {}, duel.share === null ? "none decided"
      : `${percent(duel.share)} [${fixed(100 * (low ?? NaN), kShareDigits)}, ` +
        `${fixed(100 * (high ?? NaN), kShareDigits)}]`));
}

function duelMatrix(pairings: PlannerPairing[], caption: string, palette: Palette): HTMLElement {
  const duels = new Map(pairings.flatMap(duelsOf).map((d) => [JSON.stringify([d.a, d.b]), d]));
  const find = (a: string, b: string): Duel | undefined => duels.get(JSON.stringify([a, b]));
  const planners = [...new Set([...duels.values()].map((d) => d.a))].sort(byName);
  const columns: Column<string>[] = [
    { heading: "planner", text: true, cell: (p) => plannerCell(p, palette) },
    ...planners.map((other): Column<string> => ({
      heading: `against ${other}`,
      cell: (p) => {
        const duel = find(p, other);
        return duel ? duelCell(duel, palette) : p === other ? "" : "\u2013";
      },
    })),
  ];
  return table(caption, columns, planners, (p) => palette.className(p));
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
  return table("Every pair, every group", columns, rows, () => "p7");
}

export function pairingSection(
  report: Report, palette: Palette, filter: Filter, keep: (pairing: PlannerPairing) => boolean
): HTMLElement | null {
  const pairings = report.summary.pairings.filter((p) => keep(p) &&
    filter.planners.has(p.planner_a) && filter.planners.has(p.planner_b));
  if (pairings.length === 0) return null;
  const widest = pairings.filter((p) => p.all_scenarios || filter.group ||
    !report.summary.totals.some((t) => vehicleOf(t) === vehicleOf(p)));
  const places = new Map(widest.map((p) =>
    [JSON.stringify([groupName(p), vehicleOf(p)]), `${groupName(p)}, ${vehicleOf(p)}`]));
  return el("div", {}, el("h3", { class: "vehicle" }, "Who beats whom"),
    el("p", { class: "note" }, "On the same world and repetition: reaching the goal beats not reaching " +
      "it; of two that reached it the shorter path wins, unless the path ratios are within 1 %; two " +
      "failures tie. Each cell: won\u2013tied\u2013lost by the planner of the row, and its share of the " +
      "decided with a 95 % interval."),
    ...[...places].map(([key, caption]) => duelMatrix(
      widest.filter((p) => JSON.stringify([groupName(p), vehicleOf(p)]) === key),
      `Won, tied, lost: ${caption}`, palette)),
    el("details", {}, el("summary", {}, "As a sortable list, every group"),
      pairingTable(pairings, report.vehicles.length > 1 && !filter.vehicle)));
}
