// Share of ALL trials that reached the goal with at most this value: failures are a plateau below 1.
import { axisLeft } from "d3-axis";
import { ascending, bisectRight, quantile } from "d3-array";
import { scaleLinear } from "d3-scale";

import { csv, fixed, percent, svg } from "../elements/dom";
import { drawAxes, figureOf, frame, kHeight, kMargin, kWidth, legend } from "./figure";
import { failed } from "../data/outcomes";
import { Palette } from "../elements/palette";
import { Sample, Value } from "../data/sample";
import { probe } from "../elements/tooltip";

interface Curve {
  planner: string;
  total: number;
  values: number[];  // of those that reached the goal, ascending
}

function curveOf(sample: Sample, value: Value): Curve {
  return {
    planner: sample.planner,
    total: sample.trials.length,
    values: sample.trials.filter((t) => !failed(t.outcome) && !Number.isNaN(value(t))).map(value)
      .sort(ascending),
  };
}

// A few stragglers must not squeeze the rest: they are counted where the axis ends.
function domainOf(all: number[], from: number): [number, number] {
  const low = Math.min(from, all[0] ?? from);
  const last = all[all.length - 1] ?? low + 1;
  const limit = Math.min(last, Math.max(2 * ((quantile(all, 0.98) ?? last) - low) + low, low + 0.1));
  return [low, limit > low ? limit : low + 1];
}

function drawCurve(curve: Curve, x: any, y: any, low: number, palette: Palette): SVGElement {
  const end = x.domain()[1];
  let path = `M${x(low).toFixed(1)},${y(0).toFixed(1)}`;
  curve.values.forEach((v, i) => {
    path += `H${x(Math.min(v, end)).toFixed(1)}V${y((i + 1) / curve.total).toFixed(1)}`;
  });
  path += `H${x(end).toFixed(1)}`;
  const share = curve.values.length / Math.max(1, curve.total);
  return svg("g", { class: palette.className(curve.planner), "data-planner": curve.planner,
    "data-plateau": share },
    svg("path", { class: "curve", d: path, "stroke-dasharray": palette.dash(curve.planner) }),
    svg("path", { d: palette.symbolPath(curve.planner, 60), fill: "var(--planner)",
      transform: `translate(${x(end) - 4},${y(share)})`,
      "data-tip": `${curve.planner}: ${curve.values.length} of ${curve.total} trials reached the ` +
        `goal, median of these ${fixed(quantile(curve.values, 0.5), 3)}` }));
}

export function ecdfPlot(
  id: string, title: string, xName: string, samples: Sample[], value: Value, palette: Palette,
  from: number
): HTMLElement {
  const curves = samples.map((s) => curveOf(s, value));
  const all = curves.flatMap((c) => c.values).sort(ascending);
  const domain = domainOf(all, from);
  const x = scaleLinear().domain(domain).nice().range([kMargin.left, kWidth - kMargin.right]);
  const y = scaleLinear().domain([0, 1]).range([kHeight - kMargin.bottom, kMargin.top]);
  const root = frame(title);
  drawAxes(root, { x, xName, y, yName: "share of all trials", yTicks: axisLeft(y).ticks(5, "%"), yGrid: true });
  const cursor = svg("line", { class: "cursor", y1: kMargin.top, y2: kHeight - kMargin.bottom,
    visibility: "hidden" });
  root.append(...curves.map((c) => drawCurve(c, x, y, domain[0], palette)), cursor);
  probe(root, (at) => {
    if (at < kMargin.left || at > kWidth - kMargin.right) return null;
    cursor.setAttribute("x1", String(at));
    cursor.setAttribute("x2", String(at));
    cursor.setAttribute("visibility", "visible");
    const limit = x.invert(at);
    return [`${xName} \u2264 ${fixed(limit, 3)}`, ...curves.map((c) => {
      const count = bisectRight(c.values, limit);
      return `${c.planner}: ${count} of ${c.total} (${percent(count / c.total)})`;
    })].join("\n");
  }, () => cursor.setAttribute("visibility", "hidden"));
  const past = all.filter((v) => v > x.domain()[1]).length;
  return figureOf(id, title,
    "The plateau is the share that reached the goal: failures never count as large values." +
    (past > 0 ? ` ${past} values lie beyond the axis.` : ""), root,
    legend(curves.map((c) => ({ planner: c.planner, count: `${c.values.length} of n = ${c.total}` })), palette),
    () => csv(["planner", xName, "share_of_all_trials"], curves.flatMap((c) =>
      c.values.map((v, i) => [c.planner, v, (i + 1) / c.total]))));
}
