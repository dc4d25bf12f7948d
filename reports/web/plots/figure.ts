// The frame that all plots share: a title, axes with names, a legend with n, and buttons that take the
// plot away as SVG and its numbers as CSV.
import { axisBottom, axisLeft } from "d3-axis";
import { select } from "d3-selection";

import { button, el, nameOf, saveText, svg } from "../elements/dom";
import { Palette } from "../elements/palette";
import { standaloneSvg } from "../elements/take_away";

export const kWidth = 560;
export const kHeight = 340;
export const kMargin = { top: 12, right: 28, bottom: 46, left: 58 };

export function frame(label: string, height = kHeight): SVGElement {
  return svg("svg", { viewBox: `0 0 ${kWidth} ${height}`, role: "img", "aria-label": label });
}

// On a logarithmic axis a line per digit would be a thicket: powers of ten, if there are two of them.
function gridValues(scale: any): number[] {
  const ticks: number[] = scale.ticks(7);
  const powers = scale.base ? ticks.filter((v) => Math.abs(Math.log10(v) % 1) < 1e-9) : ticks;
  return powers.length >= 2 ? powers : ticks;
}

export interface Axes {
  x: any;
  xName: string;
  xTicks?: any;
  y: any;  // null: rows that name themselves
  yName: string;
  yTicks?: any;
  yGrid?: boolean;
  height?: number;  // of the frame
}

export function drawAxes(root: SVGElement, axes: Axes): void {
  const { x, y } = axes;
  const height = axes.height ?? kHeight;
  const inner = height - kMargin.bottom;
  const grid = select(root).append("g").attr("class", "grid");
  grid.append("g").attr("transform", `translate(0,${inner})`)
    .call(axisBottom(x).tickValues(axes.xTicks?.tickValues() ?? gridValues(x)).tickSize(kMargin.top - inner).tickFormat(() => ""))
    .select(".domain").remove();
  if (axes.yGrid) {
    grid.append("g").attr("transform", `translate(${kMargin.left},0)`)
      .call(axisLeft(y).tickValues(gridValues(y)).tickSize(kMargin.left + kMargin.right - kWidth)
        .tickFormat(() => ""))
      .select(".domain").remove();
  }
  select(root).append("g").attr("class", "axis").attr("transform", `translate(0,${inner})`)
    .call(axes.xTicks ?? axisBottom(x).ticks(7));
  if (y) {
    select(root).append("g").attr("class", "axis").attr("transform", `translate(${kMargin.left},0)`)
      .call(axes.yTicks ?? axisLeft(y).ticks(5));
  }
  root.append(
    svg("text", { class: "label", x: (kMargin.left + kWidth - kMargin.right) / 2, y: height - 8,
      "text-anchor": "middle" }, axes.xName),
    svg("text", { class: "label", x: 14, y: (kMargin.top + inner) / 2, "text-anchor": "middle",
      transform: `rotate(-90 14 ${(kMargin.top + inner) / 2})` }, axes.yName));
}

// An entry is called like its planner unless it has another name.
export function legend(entries: { planner: string; name?: string; count: string }[], palette: Palette): HTMLElement {
  return el("div", { class: "legend" }, ...entries.map((entry) => el("span", {},
    palette.swatch(entry.planner), nameOf(entry.name ?? entry.planner), el("span", { class: "soft" }, entry.count))));
}

export function figureOf(
  id: string, title: string, note: string, picture: SVGElement, key: HTMLElement | null,
  data: () => string
): HTMLElement {
  return el("figure", { id },
    el("figcaption", {}, el("h3", {}, title),
      button("SVG", `Save "${title}" as SVG`, () =>
        saveText(`${id}.svg`, "image/svg+xml", standaloneSvg(picture, title, key))),
      button("CSV", `Save the numbers of "${title}" as CSV`, () =>
        saveText(`${id}.csv`, "text/csv", data()))),
    key, picture, note && el("p", { class: "note" }, note));
}
