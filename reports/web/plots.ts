// Distributions: every plot has a title, axes with units, a legend with n, tooltips, and can be taken
// away as SVG or CSV.
import { axisBottom, axisLeft } from "d3-axis";
import { ascending, quantile } from "d3-array";
import { scaleBand, scaleLinear, scaleLog } from "d3-scale";
import { select } from "d3-selection";

import { kGoal, Trial } from "./data";
import { button, csv, el, fixed, nameOf, saveText, svg } from "./dom";
import { outcomeWords, Palette } from "./palette";
import { standaloneSvg } from "./take_away";

const kWidth = 560;
const kHeight = 340;
const kMargin = { top: 12, right: 28, bottom: 46, left: 58 };

export interface Sample {
  planner: string;
  trials: Trial[];
}

type Value = (trial: Trial) => number;

function frame(label: string): SVGElement {
  return svg("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": label });
}

// On a logarithmic axis a line per digit would be a thicket: powers of ten, if there are two of them.
function gridValues(x: any): number[] {
  const ticks: number[] = x.ticks(7);
  const powers = x.base ? ticks.filter((v) => Math.abs(Math.log10(v) % 1) < 1e-9) : ticks;
  return powers.length >= 2 ? powers : ticks;
}

function drawAxes(root: SVGElement, x: any, y: any, xName: string, yName: string, xTicks: any): void {
  const inner = kHeight - kMargin.bottom;
  select(root).append("g").attr("class", "grid").attr("transform", `translate(0,${inner})`)
    .call(axisBottom(x).tickValues(gridValues(x)).tickSize(kMargin.top - inner)
      .tickFormat("" as any))
    .select(".domain").remove();
  select(root).append("g").attr("class", "axis").attr("transform", `translate(0,${inner})`)
    .call(xTicks ?? axisBottom(x).ticks(7));
  if (y) {
    select(root).append("g").attr("class", "axis").attr("transform", `translate(${kMargin.left},0)`)
      .call(axisLeft(y).ticks(5, "%"));
  }
  root.append(
    svg("text", { class: "label", x: (kMargin.left + kWidth - kMargin.right) / 2, y: kHeight - 8,
      "text-anchor": "middle" }, xName),
    svg("text", { class: "label", x: 14, y: (kMargin.top + inner) / 2, "text-anchor": "middle",
      transform: `rotate(-90 14 ${(kMargin.top + inner) / 2})` }, yName));
}

function legend(samples: Sample[], palette: Palette, count: (s: Sample) => string): HTMLElement {
  return el("div", { class: "legend" }, ...samples.map((s) => el("span", {}, palette.swatch(s.planner),
    nameOf(s.planner), el("span", { class: "soft" }, count(s)))));
}

export function figureOf(
  id: string, title: string, note: string, picture: SVGElement, key: HTMLElement | null,
  data: () => string
): HTMLElement {
  return el("figure", { id },
    el("figcaption", {}, el("h3", {}, title),
      button("SVG", "Save this plot as SVG", () =>
        saveText(`${id}.svg`, "image/svg+xml", standaloneSvg(picture, title))),
      button("CSV", "Save the numbers of this plot as CSV", () =>
        saveText(`${id}.csv`, "text/csv", data()))),
    key, picture, note && el("p", { class: "note" }, note));
}

// Share of ALL trials that reached the goal with at most this value: failures are a plateau below 1.
export function ecdfPlot(
  id: string, title: string, xName: string, samples: Sample[], value: Value, palette: Palette,
  from: number
): HTMLElement {
  const curves = samples.map((s) => ({
    ...s,
    values: s.trials.filter((t) => t.outcome === kGoal && !Number.isNaN(value(t))).map(value)
      .sort(ascending),
  }));
  const all = curves.flatMap((c) => c.values).sort(ascending);
  const low = Math.min(from, all[0] ?? from);
  const last = all[all.length - 1] ?? low + 1;
  // A few stragglers must not squeeze the rest: they are counted where the axis ends.
  const limit = Math.min(last, Math.max(2 * ((quantile(all, 0.98) ?? last) - low) + low, low + 0.1));
  const x = scaleLinear().domain([low, limit > low ? limit : low + 1]).nice()
    .range([kMargin.left, kWidth - kMargin.right]);
  const y = scaleLinear().domain([0, 1]).range([kHeight - kMargin.bottom, kMargin.top]);
  const root = frame(title);
  drawAxes(root, x, y, xName, "share of all trials", null);
  const end = x.domain()[1];
  for (const curve of curves) {
    const total = curve.trials.length;
    let path = `M${x(low).toFixed(1)},${y(0).toFixed(1)}`;
    curve.values.forEach((v, i) => {
      const at = Math.min(v, end);
      path += `H${x(at).toFixed(1)}V${y((i + 1) / total).toFixed(1)}`;
    });
    path += `H${x(end).toFixed(1)}`;
    const share = curve.values.length / Math.max(1, total);
    root.append(
      svg("g", { class: palette.className(curve.planner), "data-planner": curve.planner,
        "data-plateau": share },
        svg("path", { class: "curve", d: path, "stroke-dasharray": palette.dash(curve.planner) },
          svg("title", {}, `${curve.planner}: ${curve.values.length} of ${total} trials reached the ` +
            `goal, median ${fixed(quantile(curve.values, 0.5), 2)}`)),
        svg("path", { d: palette.symbolPath(curve.planner, 60), fill: "var(--planner)",
          transform: `translate(${x(end) - 4},${y(share)})` })));
  }
  const past = all.filter((v) => v > end).length;
  return figureOf(id, title,
    "The plateau is the share that reached the goal: failures never count as large values." +
    (past > 0 ? ` ${past} values lie beyond the axis.` : ""), root,
    legend(curves, palette, (s) => `${(s as any).values.length} of n = ${s.trials.length}`),
    () => csv(["planner", xName, "share_of_all_trials"], curves.flatMap((c) =>
      c.values.map((v, i) => [c.planner, v, (i + 1) / c.trials.length]))));
}

// Spread of the dots of a strip: a fixed pattern, so that the same data draws the same picture.
function jitter(index: number): number {
  return ((index * 0.6180339887) % 1) - 0.5;
}

const kMostDots = 400;

function shortened(name: string): string {
  return name.length > 40 ? `${name.slice(0, 39)}\u2026` : name;
}

function drawBox(g: SVGElement, values: number[], x: (v: number) => number, mid: number,
                 half: number): void {
  const at = (p: number): number => quantile(values, p) as number;
  g.append(
    svg("line", { class: "whisker", x1: x(at(0.05)), x2: x(at(0.95)), y1: mid, y2: mid }),
    svg("rect", { class: "box", x: x(at(0.25)), width: Math.max(1, x(at(0.75)) - x(at(0.25))),
      y: mid - half, height: 2 * half },
      svg("title", {}, `median ${fixed(at(0.5), 3)}, quartiles ${fixed(at(0.25), 3)} to ` +
        `${fixed(at(0.75), 3)}, 5 to 95 %: ${fixed(at(0.05), 3)} to ${fixed(at(0.95), 3)}`)),
    svg("line", { class: "median", x1: x(at(0.5)), x2: x(at(0.5)), y1: mid - half, y2: mid + half }));
}

// One row per planner: box from quartile to quartile, whiskers at 5 and 95 %, every trial as a dot,
// those that failed hollow.
export function stripPlot(
  id: string, title: string, xName: string, note: string, samples: Sample[], value: Value,
  palette: Palette, logarithmic: boolean
): HTMLElement {
  const rows = samples.map((s) => ({
    ...s, shown: s.trials.filter((t) => !Number.isNaN(value(t)) && (!logarithmic || value(t) > 0)),
  })).filter((row) => row.shown.length > 0);
  const all = rows.flatMap((r) => r.shown.map(value)).sort(ascending);
  const span: [number, number] = [all[0] ?? (logarithmic ? 1 : 0), all[all.length - 1] ?? 1];
  if (!logarithmic) span[0] = Math.min(0, span[0]);
  if (span[0] === span[1]) span[1] = span[0] * 2 || 1;
  const range: [number, number] = [kMargin.left, kWidth - kMargin.right];
  const x = logarithmic ? scaleLog().domain([span[0] / 1.2, span[1] * 1.2]).range(range)
    : scaleLinear().domain(span).nice().range(range);
  const band = scaleBand<string>().domain(rows.map((r) => r.planner))
    .range([kMargin.top, kHeight - kMargin.bottom]).padding(0.25);
  const root = frame(title);
  drawAxes(root, x, null, xName, "planner", logarithmic ? axisBottom(x).ticks(5, "~g") : null);
  for (const row of rows) {
    const mid = (band(row.planner) ?? 0) + band.bandwidth() / 2;
    const half = Math.min(18, band.bandwidth() * 0.32);
    const g = svg("g", { class: palette.className(row.planner), "data-planner": row.planner });
    const step = Math.max(1, Math.ceil(row.shown.length / kMostDots));
    row.shown.forEach((trial, i) => {
      if (i % step !== 0 && trial.outcome === kGoal) return;
      g.append(svg("circle", { class: trial.outcome === kGoal ? "dot" : "failed", r: 2.6,
        cx: x(value(trial)).toFixed(1), cy: (mid + 2 * half * jitter(i)).toFixed(1) },
        svg("title", {}, `${row.planner}, ${trial.scenario}, repetition ${trial.repetition}: ` +
          `${fixed(value(trial), 3)}, ${outcomeWords(trial.outcome)}`)));
    });
    if (row.shown.length > 0) {
      drawBox(g, row.shown.map(value).sort(ascending), x, mid, half);
    }
    g.append(
      svg("path", { d: palette.symbolPath(row.planner, 60), fill: "var(--planner)",
        transform: `translate(${kMargin.left - 14},${mid})` }),
      svg("text", { class: "faint", x: kMargin.left + 4, y: mid - half - 6 }, shortened(row.planner)));
    root.append(g);
  }
  return figureOf(id, title,
    "Box: quartiles and median; whiskers: 5 and 95 %; dots: trials, hollow where they failed. " + note,
    root, legend(rows, palette, (s) => `n = ${(s as any).shown.length}`),
    () => csv(["planner", "trial_id", "outcome", xName], rows.flatMap((r) =>
      r.shown.map((t) => [r.planner, t.trial_id, t.outcome, value(t)]))));
}
