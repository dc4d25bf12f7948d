// Quantities over time, one line per trial, with the replay's moment as a cursor; a press goes there.
import { axisBottom, axisLeft } from "d3-axis";
import { scaleLinear } from "d3-scale";
import { select } from "d3-selection";

import { Trial } from "../data/data";
import { csv, fixed, svg } from "../elements/dom";
import { Palette } from "../elements/palette";
import { figureOf, legend } from "../plots/figure";
import { frameAt } from "./replay_geometry";
import { probe } from "../elements/tooltip";
import { Frames, Trace } from "../data/trace";

export const kWidth = 560;
export const kHeight = 170;
export const kMargin = { top: 8, right: 12, bottom: 34, left: 60 };

export interface Quantity {
  id: string;
  title: string;
  unit: string;
  lines: (frames: Frames) => Float64Array[];
  flown?: boolean;  // only of what flew
}

const kDegrees = 180 / Math.PI;

export const kQuantities: Quantity[] = [
  { id: "speed", flown: true, title: "Speed", unit: "m/s", lines: (f) => [f.speed_m_s] },
  { id: "clearance", title: "Clearance, centre to surface", unit: "m", lines: (f) => [f.clearance_m] },
  { id: "share", flown: true, title: "Speed that the governor allowed", unit: "% of what was asked",
    lines: (f) => f.tube.some((tube) => tube.length > 0) ? [f.share.map((v) => 100 * v)] : [] },
  { id: "tilt", flown: true, title: "Tilt", unit: "degrees", lines: (f) => [f.tilt_rad.map((v) => v * kDegrees)] },
  { id: "planning", flown: true, title: "Planning time per scan (measured)", unit: "\u00B5s",
    lines: (f) => [f.planning_time_us] },
];

// What a model does not have stays 0 (dynamics/models): four rotors, a cart's two wheels, a car's steering.
export function actuatorsOf(traces: Trace[]): Quantity {
  const used = (f: Frames): Float64Array[] => f.actuators.filter((line) => line.some((v) => v !== 0));
  const most = traces.reduce((n, { frames }) => Math.max(n, used(frames).length), 0);
  const title = most > 2 ? "Rotor speeds" : most === 2 ? "Wheel speeds, right and left" : "Steering angle";
  return { id: "actuators", flown: true, title, unit: most > 1 ? "rad/s" : "rad", lines: used };
}

export interface Series {
  element: HTMLElement;
  setTime: (t_s: number) => void;
}

function linePath(t: Float64Array, values: Float64Array, x: (v: number) => number,
                  y: (v: number) => number): string {
  let d = "";
  let pen = "M";
  values.forEach((v, i) => {
    if (Number.isNaN(v)) {
      pen = "M";
      return;
    }
    d += `${pen}${x(t[i]).toFixed(1)} ${y(v).toFixed(1)}`;
    pen = "L";
  });
  return d;
}

export function timeSeries(
  quantity: Quantity, trials: Trial[], traces: Trace[], end_s: number, palette: Palette,
  seek: (t_s: number) => void
): Series | null {
  const lines = traces.map((trace) => quantity.lines(trace.frames));
  const all = lines.flat().flatMap((line) => Array.from(line)).filter((v) => !Number.isNaN(v));
  const high = all.reduce((a, b) => Math.max(a, b), 0);
  let low = all.reduce((a, b) => Math.min(a, b), high);
  if (all.length === 0 || (high === 0 && low === 0)) return null;  // nothing was recorded
  // From zero, unless that would flatten what happens far from it.
  if (low > 0 && low < 0.7 * high) low = 0;
  if (low === high) low = 0;
  const x = scaleLinear().domain([0, end_s]).range([kMargin.left, kWidth - kMargin.right]);
  const y = scaleLinear().domain([low, high]).nice()
    .range([kHeight - kMargin.bottom, kMargin.top]);
  const root = svg("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img",
    "aria-label": `${quantity.title} in ${quantity.unit} over time` });
  select(root).append("g").attr("class", "grid").attr("transform", `translate(${kMargin.left},0)`)
    .call(axisLeft(y).ticks(4).tickSize(kMargin.left + kMargin.right - kWidth).tickFormat("" as any))
    .select(".domain").remove();
  select(root).append("g").attr("class", "axis")
    .attr("transform", `translate(0,${kHeight - kMargin.bottom})`).call(axisBottom(x).ticks(8));
  select(root).append("g").attr("class", "axis").attr("transform", `translate(${kMargin.left},0)`)
    .call(axisLeft(y).ticks(4));
  root.append(
    svg("text", { class: "label", x: (kMargin.left + kWidth) / 2, y: kHeight - 4,
      "text-anchor": "middle" }, "time in s"),
    svg("text", { class: "label", x: 12, y: kHeight / 2 - 12, "text-anchor": "middle",
      transform: `rotate(-90 12 ${kHeight / 2 - 12})` }, quantity.unit));
  lines.forEach((list, i) => {
    const g = svg("g", { class: palette.className(trials[i].planner) });
    for (const line of list) {
      g.append(svg("path", { class: "curve", d: linePath(traces[i].frames.t_s, line, x, y),
        "stroke-dasharray": palette.dash(trials[i].planner) }));
    }
    root.append(g);
  });
  const cursor = svg("line", { class: "cursor", y1: kMargin.top, y2: kHeight - kMargin.bottom });
  root.append(cursor);
  root.addEventListener("click", (event) => {
    const box = root.getBoundingClientRect();
    seek(x.invert((event.clientX - box.left) * kWidth / box.width));
  });
  probe(root, (at) => {
    if (at < kMargin.left || at > kWidth - kMargin.right) return null;
    const t_s = x.invert(at);
    return [`${fixed(t_s, 2)} s`, ...traces.map((trace, i) => {
      const k = frameAt(trace, t_s);
      return `${trials[i].planner}: ${lines[i].map((l) => fixed(l[k], 2)).join(", ") || "0"} ${quantity.unit}`;
    })].join("\n");
  }, () => undefined);
  const key = legend(trials.map((t) => ({ planner: t.planner, count: `repetition ${t.repetition}` })), palette);
  const element = figureOf(`series-${quantity.id}`, `${quantity.title} in ${quantity.unit}`, "", root,
    key, () => csv(["trial_id", "planner", "time_s", `${quantity.title} ${quantity.unit}`],
      lines.flatMap((list, i) => list.flatMap((line) => Array.from(line, (v, k) =>
        [trials[i].trial_id, trials[i].planner, traces[i].frames.t_s[k], v])))));
  return {
    element,
    setTime: (t_s) => {
      cursor.setAttribute("x1", String(x(t_s)));
      cursor.setAttribute("x2", String(x(t_s)));
    },
  };
}
