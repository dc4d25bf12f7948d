// One row per planner: box from quartile to quartile, whiskers at 5 and 95 %, every trial as a dot,
// those that failed hollow. Where the values are few they stand alone: one of them is one dot.
import { axisBottom } from "d3-axis";
import { ascending, quantile } from "d3-array";
import { scaleBand, scaleLinear, scaleLog } from "d3-scale";

import type { Trial } from "../data/data";
import { csv, fixed, svg } from "../elements/dom";
import { drawAxes, figureOf, frame, kHeight, kMargin, kWidth, legend } from "./figure";
import { failed, outcomeWords } from "../data/outcomes";
import { Palette } from "../elements/palette";
import { Sample, Value } from "../data/sample";

const kMostDots = 400;  // of a row; failures are always drawn
const kLeastRow = 34;    // a name, and a box below it
const kFewestBoxed = 6;  // below, quartiles are little more than the values

interface Row {
  planner: string;
  shown: Trial[];
}

interface Place {
  x: (v: number) => number;
  mid: number;
  half: number;
}

// Spread of the dots of a row: a fixed pattern, so that the same data draws the same picture.
function jitter(index: number): number {
  return ((index * 0.6180339887) % 1) - 0.5;
}

function shortened(name: string): string {
  return name.length > 40 ? `${name.slice(0, 39)}\u2026` : name;
}

// Enough digits for the value, not more: 0.412, 18.5, 14210.
function readable(value: number): string {
  return fixed(value, Math.abs(value) >= 1000 ? 0 : Math.abs(value) >= 10 ? 1 : 3);
}

function drawBox(g: SVGElement, row: Row, value: Value, { x, mid, half }: Place): void {
  const values = row.shown.map(value).sort(ascending);
  const at = (p: number): number => quantile(values, p) as number;
  if (values.length < kFewestBoxed) return;
  g.append(
    svg("line", { class: "whisker", x1: x(at(0.05)), x2: x(at(0.95)), y1: mid, y2: mid }),
    svg("rect", { class: "box", x: x(at(0.25)), width: Math.max(1, x(at(0.75)) - x(at(0.25))),
      y: mid - half, height: 2 * half,
      "data-tip": `${row.planner}, n = ${values.length}\nmedian ${readable(at(0.5))}\n` +
        `quartiles ${readable(at(0.25))} to ${readable(at(0.75))}\n` +
        `5 to 95 %: ${readable(at(0.05))} to ${readable(at(0.95))}` }),
    svg("line", { class: "median", x1: x(at(0.5)), x2: x(at(0.5)), y1: mid - half, y2: mid + half }));
}

function drawDots(g: SVGElement, row: Row, value: Value, { x, mid, half }: Place): void {
  const step = Math.max(1, Math.ceil(row.shown.length / kMostDots));
  row.shown.forEach((trial, i) => {
    if (i % step !== 0 && !failed(trial.outcome)) return;
    g.append(svg("circle", { class: failed(trial.outcome) ? "failed" : "dot", r: 2.6,
      cx: x(value(trial)).toFixed(1), cy: (mid + (row.shown.length < kFewestBoxed ? 0 : 2 * half * jitter(i))).toFixed(1),
      "data-tip": `${row.planner}, ${trial.scenario}, repetition ${trial.repetition}\n` +
        `${readable(value(trial))}, ${outcomeWords(trial.outcome)}` }));
  });
}

function scaleFor(all: number[], logarithmic: boolean): any {
  const span: [number, number] = [all[0] ?? (logarithmic ? 1 : 0), all[all.length - 1] ?? 1];
  if (!logarithmic) span[0] = Math.min(0, span[0]);
  if (span[0] === span[1]) span[1] = span[0] * 2 || 1;
  const range = [kMargin.left, kWidth - kMargin.right];
  return logarithmic ? scaleLog().domain([span[0] / 1.2, span[1] * 1.2]).range(range)
    : scaleLinear().domain(span).nice().range(range);
}

export function boxPlot(
  id: string, title: string, xName: string, note: string, samples: Sample[], value: Value,
  palette: Palette, logarithmic: boolean
): HTMLElement {
  const rows: Row[] = samples.map((s) => ({
    planner: s.planner,
    shown: s.trials.filter((t) => !Number.isNaN(value(t)) && (!logarithmic || value(t) > 0)),
  })).filter((row) => row.shown.length > 0);
  const x = scaleFor(rows.flatMap((r) => r.shown.map(value)).sort(ascending), logarithmic);
  const height = Math.max(kHeight, kMargin.top + kMargin.bottom + kLeastRow * rows.length);
  const band = scaleBand().domain(rows.map((r) => r.planner))
    .range([kMargin.top, height - kMargin.bottom]).padding(0.25);
  const root = frame(title, height);
  drawAxes(root, { x, xName, y: null, yName: "planner", height,
    xTicks: logarithmic ? axisBottom(x).ticks(5, "~g") : undefined });
  for (const row of rows) {
    const place = { x, mid: (band(row.planner) ?? 0) + band.bandwidth() / 2,
      half: Math.min(18, band.bandwidth() * 0.32) };
    const g = svg("g", { class: palette.className(row.planner), "data-planner": row.planner });
    drawBox(g, row, value, place);
    drawDots(g, row, value, place);
    g.append(
      svg("path", { d: palette.symbolPath(row.planner, 60), fill: "var(--planner)",
        transform: `translate(${kMargin.left - 14},${place.mid})` }),
      svg("text", { class: "faint", x: kMargin.left + 4, y: place.mid - place.half - 6 },
        shortened(row.planner)));
    root.append(g);
  }
  return figureOf(id, title,
    `Box: quartiles and median; whiskers: 5 and 95 %; dots: trials, hollow where they failed; ` +
      `no box of fewer than ${kFewestBoxed}. ${note}`,
    root, legend(rows.map((r) => ({ planner: r.planner, count: `n = ${r.shown.length}` })), palette),
    () => csv(["planner", "trial_id", "outcome", xName], rows.flatMap((r) =>
      r.shown.map((t) => [r.planner, t.trial_id, t.outcome, value(t)]))));
}
