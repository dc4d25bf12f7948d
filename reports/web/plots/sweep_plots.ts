// Sweeps as lines, with bands that are 95 % intervals; where the values are too few for one, they are drawn.
import { axisBottom, axisLeft } from "d3-axis";
import { scaleLinear, scaleLog } from "d3-scale";

import type { Report, Statistic } from "../data/data";
import { csv, el, fixed, percent, svg } from "../elements/dom";
import { drawAxes, figureOf, frame, kHeight, kMargin, kWidth, legend } from "./figure";
import { Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { axesWithoutLine, Sweep, SweepPoint, sweepsOf } from "../data/sweep";

interface Drawn {
  label: string;
  planner: string;
  points: (SweepPoint & { y: number; low: number; high: number; n: number; few: number[] })[];
}

function drawn(sweep: Sweep, metric: Statistic): Drawn[] {
  return sweep.lines.map((line) => ({
    ...line,
    points: line.points.map((p) => {
      const { value, interval, n, too_few } = p.summary.statistics[metric.name];
      const y = value ?? NaN;
      const few = (too_few ?? []).filter((v) => !metric.logarithmic || v > 0);
      return { ...p, y, n, few, low: interval[0] ?? NaN, high: interval[1] ?? NaN };
    }).filter((p) => !Number.isNaN(p.y) && (!metric.logarithmic || p.y > 0)),
  })).filter((line) => line.points.length > 0);
}

function written(value: number, metric: Statistic): string {
  return metric.rate ? percent(value, metric.digits) : fixed(value, metric.digits);
}

function axisName(metric: Statistic): string {
  return metric.heading.replace("\n", ", ") + (metric.logarithmic ? " (logarithmic)" : "");
}

function titleOf(metric: Statistic, sweep: Sweep): string {
  return `${metric.heading.replace("\n", ", ")} ${sweep.title}`;
}

function yScale(lines: Drawn[], metric: Statistic): any {
  const range = [kHeight - kMargin.bottom, kMargin.top];
  if (metric.rate) return scaleLinear().domain([0, 1]).range(range);
  const points = lines.flatMap((l) => l.points);
  const shown = points.flatMap((p) => [p.y, p.low, p.high, ...p.few])
    .filter((v) => metric.logarithmic ? v > 0 : !Number.isNaN(v));
  const low = shown.reduce((m, v) => Math.min(m, v), Infinity);
  const high = shown.reduce((m, v) => Math.max(m, v), -Infinity);
  if (metric.logarithmic) return scaleLog().domain([low / 1.2, high * 1.2]).range(range);
  const around = (high - low) * 0.05 || Math.abs(high) * 0.05 || 1;
  return scaleLinear().domain([low - around, high + around]).nice().range(range);
}

type Point = Drawn["points"][number];

// Between neighbours that both have an interval; one that has none beside it has a line instead.
function bandsOf(points: Point[]): Point[][] {
  const runs: Point[][] = [[]];
  for (const p of points) {
    if (Number.isNaN(p.low)) runs.push([]);
    else runs[runs.length - 1].push(p);
  }
  return runs.filter((run) => run.length > 0);
}

function spreadOf(p: Point, metric: Statistic): string {
  if (p.few.length === 1) return "one value";
  if (p.few.length > 1) return `too few for an interval: ${p.few.map((v) => written(v, metric)).join(", ")}`;
  return Number.isNaN(p.low) ? "" : `95 % [${written(p.low, metric)}, ${written(p.high, metric)}]`;
}

function drawLine(line: Drawn, metric: Statistic, x: any, y: any, palette: Palette): SVGElement {
  const at = (list: [number, number][]): string => list.map(([a, b], i) =>
    `${i ? "L" : "M"}${x(a).toFixed(1)} ${y(b).toFixed(1)}`).join("");
  const floor = (p: { low: number; y: number }): number => metric.logarithmic && p.low <= 0 ? p.y : p.low;
  const band = (run: Point[]): SVGElement => run.length === 1
    ? svg("line", { class: "whisker", x1: x(run[0].x), x2: x(run[0].x), y1: y(run[0].high), y2: y(floor(run[0])) })
    : svg("path", { class: "band", d: `${at([...run.map((p): [number, number] => [p.x, p.high]),
      ...[...run].reverse().map((p): [number, number] => [p.x, floor(p)])])}Z` });
  return svg("g", { class: palette.className(line.planner), "data-planner": line.label },
    ...bandsOf(line.points).map(band),
    ...line.points.flatMap((p) => p.few.length < 2 ? [] : p.few.map((v) =>
      svg("circle", { class: "few", r: 2.4, cx: x(p.x).toFixed(1), cy: y(v).toFixed(1) }))),
    svg("path", { class: "curve", d: at(line.points.map((p) => [p.x, p.y])),
      "stroke-dasharray": palette.dash(line.planner) }),
    ...line.points.map((p) => svg("path", { class: "point", d: palette.symbolPath(line.planner, 64),
      transform: `translate(${x(p.x).toFixed(1)},${y(p.y).toFixed(1)})`, "data-value": p.y,
      "data-tip": `${line.label} at ${p.x}, ${p.summary.scenario_group}\n` +
        [`${written(p.y, metric)}`, spreadOf(p, metric)].filter((t) => t).join(", ") + `\nn = ${p.n}` })));
}

const kTickWidth_px = 30;

// At the swept values; of those that would run into the one before, none but the last.
function ticksAt(values: number[], x: any): any {
  const kept: number[] = [];
  for (const v of values) {
    const far = (other: number): boolean => x(v) - x(other) >= kTickWidth_px;
    if (v === values[values.length - 1]) while (kept.length > 1 && !far(kept[kept.length - 1])) kept.pop();
    if (kept.every(far)) kept.push(v);
  }
  return axisBottom(x).tickValues(kept).tickFormat((v: number) => String(Number(v.toPrecision(4))));
}

function metricPlot(id: string, sweep: Sweep, metric: Statistic, palette: Palette): HTMLElement | null {
  const lines = drawn(sweep, metric);
  if (lines.length === 0) return null;
  const xs = lines.flatMap((l) => l.points.map((p) => p.x));
  const span = [Math.min(...xs), Math.max(...xs)];
  if (span[0] === span[1]) return null;
  const x = (sweep.ratios ? scaleLog() : scaleLinear()).domain(span)
    .range([kMargin.left + 14, kWidth - kMargin.right]);
  const y = yScale(lines, metric);
  const root = frame(titleOf(metric, sweep));
  drawAxes(root, { x, xName: sweep.xName + (sweep.ratios ? " (logarithmic)" : ""),
    xTicks: ticksAt([...new Set(xs)].sort((a, b) => a - b), x), y, yName: axisName(metric), yGrid: true,
    yTicks: metric.rate ? axisLeft(y).ticks(5, "%") : metric.logarithmic ? axisLeft(y).ticks(5, "~g")
      : undefined });
  root.append(...lines.map((line) => drawLine(line, metric, x, y, palette)));
  const counts = (line: Drawn): string => {
    const ns = line.points.map((p) => p.n);
    const [few, many] = [Math.min(...ns), Math.max(...ns)];
    return few === many ? `n = ${few} each` : `n = ${few} to ${many}`;
  };
  return figureOf(id, titleOf(metric, sweep), sweep.held && `Held: ${sweep.held}`, root,
    legend(lines.map((l) => ({ planner: l.planner, name: l.label, count: counts(l) })), palette),
    () => csv(["planner", sweep.xName, axisName(metric), "low_95", "high_95", "n", "held"],
      lines.flatMap((l) => l.points.map((p) => [l.label, p.x, p.y, p.low, p.high, p.n, sweep.held]))));
}

export function sweepSection(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const sweeps = sweepsOf(report, filter);
  const shown = report.summary.statistics.filter((s) => s.in_sweeps);
  const without = axesWithoutLine(report);
  if (sweeps.length === 0) {
    return el("p", { class: "soft" }, "No sweep in this selection: a sweep is an axis of the suite with " +
      "two or more values, or three or more scenario groups, or planners of one name, that differ in one " +
      "number.");
  }
  return el("div", {},
    el("p", {}, "Bands are 95 % intervals, of six values or more but for shares; where fewer are, rings are the " +
      "values themselves. A failure counts in the share that arrives; path ratio and " +
      "time are over those that arrived, whose n a point tells. Where the suite sweeps over more than one " +
      "key, each drawing holds the others at the values below it; nothing is averaged over them."),
    without.length > 0 && el("p", { class: "soft" }, `Without numbers, and so without a line: ${without.join(", ")}. ` +
      "The overview tells them apart by their names."),
    ...sweeps.flatMap((sweep, i) => [
      el("h3", { class: "vehicle" }, [sweep.xName, sweep.vehicle, sweep.held].filter((t) => t).join(", ")),
      el("div", { class: "plots" }, ...shown.map((metric) =>
        metricPlot(`sweep-${i}-${metric.name}`, sweep, metric, palette))),
    ]));
}
