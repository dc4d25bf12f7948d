// Numbers with what they rest on: interval, n.
import type { Estimate, Rate, Statistic } from "../data/data";
import { el, fixed, kShareDigits, nameOf, percent, svg } from "./dom";
import { Palette } from "./palette";

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

export function rateCell(rate: Rate, digits = kShareDigits): HTMLElement {
  const [low, high] = rate.interval;
  return el("span", {}, rateBar(rate), ` ${percent(rate.value, digits)} `,
    el("small", {}, `${rate.successes}/${rate.n}, 95 % [${fixed(100 * (low ?? NaN), digits)}, ` +
      `${fixed(100 * (high ?? NaN), digits)}]`));
}

// What stands behind a bootstrapped value: its interval, or the values where they are too few for one.
export function spreadText(estimate: Estimate, digits: number): string {
  const [low, high] = estimate.interval;
  const few = estimate.too_few ?? [];
  if (few.length === 1) return "one value";
  if (few.length > 1) return `too few: ${few.map((v) => fixed(v, digits)).join(", ")}`;
  return low === null ? "" : `[${fixed(low, digits)}, ${fixed(high, digits)}]`;
}

// A number of the table of statistics, of `ofAll` trials.
export function statisticCell(statistic: Statistic, estimate: Estimate, ofAll: number): HTMLElement {
  if (statistic.rate) return rateCell(estimate as Rate, statistic.digits);
  const parts = [spreadText(estimate, statistic.digits)].filter((t) => t);
  if (estimate.n !== ofAll) parts.push(`over ${estimate.n}`);
  return el("span", {}, fixed(estimate.value, statistic.digits),
    parts.length > 0 && el("small", {}, parts.join(" ")));
}

export function plannerCell(planner: string, palette: Palette): HTMLElement {
  return el("span", {}, palette.swatch(planner), " ", nameOf(planner));
}

export function groupName(key: { all_scenarios: boolean; scenario_group: string }): string {
  return key.all_scenarios ? "all scenarios" : key.scenario_group;
}
