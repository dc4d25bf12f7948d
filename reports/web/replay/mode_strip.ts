// The mode of each trial over time as a strip of named stretches: where it changes its mind.
import { axisBottom } from "d3-axis";
import { scaleLinear } from "d3-scale";
import { select } from "d3-selection";

import type { Trial } from "../data/data";
import { csv, svg } from "../elements/dom";
import { figureOf, legend } from "../plots/figure";
import { Palette } from "../elements/palette";
import { kHeight, kMargin, kWidth, Series } from "./time_series";
import { Trace } from "../data/trace";

interface Stretch {
  mode: number;  // index into Trace.modes
  name: string;
  from_s: number;
  to_s: number;
}

export function wordsOf(name: string): string {
  return name.replace(/_/g, " ");
}

export function stretchesOf(trace: Trace): Stretch[] {
  const { mode, t_s, count } = trace.frames;
  const stretches: Stretch[] = [];
  for (let k = 0; k < count; ++k) {
    const name = wordsOf(trace.modes[mode[k]] ?? "");
    const last = stretches[stretches.length - 1];
    if (last) last.to_s = t_s[k];
    if (!last || last.name !== name) stretches.push({ mode: mode[k], name, from_s: t_s[k], to_s: t_s[k] });
  }
  return stretches.filter((s) => s.name !== "");
}

export function modeStrip(
  trials: Trial[], traces: Trace[], end_s: number, palette: Palette, seek: (t_s: number) => void
): Series | null {
  const rows = traces.map(stretchesOf);
  if (rows.every((row) => row.length === 0)) return null;
  const x = scaleLinear().domain([0, end_s]).range([kMargin.left, kWidth - kMargin.right]);
  const inner = kHeight - kMargin.bottom;
  const title = "Mode or state of the executive";
  const root = svg("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": title });
  select(root).append("g").attr("class", "axis").attr("transform", `translate(0,${inner})`)
    .call(axisBottom(x).ticks(8));
  root.append(svg("text", { class: "label", x: (kMargin.left + kWidth) / 2, y: kHeight - 4,
    "text-anchor": "middle" }, "time in s"));
  const high = (inner - kMargin.top) / rows.length;
  rows.forEach((row, i) => {
    const y = kMargin.top + i * high;
    const g = svg("g", { class: palette.className(trials[i].planner) },
      svg("path", { d: palette.symbolPath(trials[i].planner, 60), fill: "var(--planner)",
        transform: `translate(${kMargin.left - 14},${y + high / 2})` }));
    row.forEach((s) => {
      const width = Math.max(1, x(s.to_s) - x(s.from_s));
      g.append(svg("rect", { class: `mode m${s.mode % 4}`, x: x(s.from_s), width,
        y: y + 2, height: high - 4,
        "data-tip": `${trials[i].planner}: ${s.name}\n${s.from_s.toFixed(2)} to ${s.to_s.toFixed(2)} s` }));
      if (width > 7 * s.name.length) {
        g.append(svg("text", { class: "mode-name", x: x(s.from_s) + width / 2, y: y + high / 2 + 4,
          "text-anchor": "middle" }, s.name));
      }
    });
    const { replan, t_s } = traces[i].frames;
    replan.forEach((reason, k) => {
      if (reason < 0) return;
      g.append(svg("line", { class: "replan", x1: x(t_s[k]), x2: x(t_s[k]), y1: y + high - 9, y2: y + high - 2,
        "data-tip": `${trials[i].planner} plans again at ${t_s[k].toFixed(2)} s: ` +
          wordsOf(traces[i].replan_reasons[reason]) }));
    });
    root.append(g);
  });
  const cursor = svg("line", { class: "cursor", y1: kMargin.top, y2: inner });
  root.append(cursor);
  root.addEventListener("click", (event) => {
    const box = root.getBoundingClientRect();
    seek(x.invert((event.clientX - box.left) * kWidth / box.width));
  });
  const key = legend(trials.map((t) => ({ planner: t.planner, count: `repetition ${t.repetition}` })), palette);
  return {
    element: figureOf("series-mode", title, "Ticks: the planner was asked again.", root, key,
      () => csv(["trial_id", "planner", "mode", "from_s", "to_s"], rows.flatMap((row, i) =>
        row.map((s) => [trials[i].trial_id, trials[i].planner, s.name, s.from_s, s.to_s])))),
    setTime: (t_s) => {
      cursor.setAttribute("x1", String(x(t_s)));
      cursor.setAttribute("x2", String(x(t_s)));
    },
  };
}
