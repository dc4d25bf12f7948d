// What the mapping step costs beside other maps, how the cost grows, and what it makes of recorded
// lidar: a page of a run's report, or a report of its own.
import { axisBottom, axisLeft } from "d3-axis";
import { scaleLog } from "d3-scale";

import type { MappingData } from "../data/data";
import { button, csv, el, fixed, saveText, svg } from "../elements/dom";
import { drawAxes, figureOf, frame, kHeight, kMargin, kWidth, legend } from "../plots/figure";
import type { MappedLog } from "../data/mapped_log";
import { drawLog } from "../plots/mapped_log";
import { Cost, costsOf, exponentOf, kAnswers } from "../data/micro_results";
import { Palette } from "../elements/palette";

export interface MappingResults extends MappingData {
  title: string;
}

const kOwn = "voronaut";

function tableOf(head: string[], rows: string[][], texts: number): HTMLElement {
  const cell = (tag: "th" | "td", text: string, i: number): HTMLElement =>
    el(tag, i === 0 || i >= head.length - texts ? { class: "text" } : {}, text);
  return el("div", { class: "scroll" }, el("table", {},
    el("thead", {}, el("tr", {}, ...head.map((text, i) => cell("th", text, i)))),
    el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map((text, i) => cell("td", text, i)))))));
}

function costTable(costs: Cost[]): HTMLElement {
  const rays = [...new Set(costs.map((c) => c.at))].sort((a, b) => a - b);
  const maps = [...new Set(costs.map((c) => c.map))];
  const us = (map: string, at: number): number =>
    costs.find((c) => c.map === map && c.at === at)?.us ?? NaN;
  const rows = maps.map((map) => [map, ...rays.map((r) => fixed(us(map, r), 2)),
    ...rays.map((r) => `${fixed(us(map, r) / us(kOwn, r), us(map, r) < us(kOwn, r) ? 2 : 1)} \u00D7`),
    ...(kAnswers[map] ?? ["", ""])]);
  const head = ["map", ...rays.map((r) => `\u00B5s, ${r} rays`), ...rays.map((r) => `ratio, ${r} rays`),
    "also answers", "does not answer"];
  return el("div", {}, tableOf(head, rows, 2),
    button("CSV", "Save these numbers as CSV", () => saveText("mapping-cost.csv", "text/csv", csv(head, rows))));
}

// Cost over an argument, both logarithmic, one line per map.
function linesOf(id: string, title: string, xName: string, costs: Cost[], note: string): HTMLElement {
  const maps = [...new Set(costs.map((c) => c.map))];
  const palette = new Palette(maps);
  const span = (values: number[]): [number, number] => [Math.min(...values) / 1.2, Math.max(...values) * 1.2];
  const x = scaleLog().domain(span(costs.map((c) => c.at))).range([kMargin.left, kWidth - kMargin.right]);
  const y = scaleLog().domain(span(costs.map((c) => c.us))).range([kHeight - kMargin.bottom, kMargin.top]);
  const root = frame(title);
  const ats = [...new Set(costs.map((c) => c.at))];
  const yName = "CPU time per scan in \u00B5s";
  drawAxes(root, { x, xName, y, yName, yGrid: true, yTicks: axisLeft(y).ticks(5, "~g"),
    xTicks: axisBottom(x).tickValues(ats).tickFormat((v: any) => String(v)) });
  for (const map of maps) {
    const own = costs.filter((c) => c.map === map).sort((a, b) => a.at - b.at);
    const path = own.map((c, k) => `${k ? "L" : "M"}${x(c.at).toFixed(1)},${y(c.us).toFixed(1)}`).join("");
    root.append(svg("g", { class: palette.className(map), "data-map": map },
      svg("path", { class: "curve", d: path, "stroke-dasharray": palette.dash(map) }),
      ...own.map((c) => svg("path", { class: "point", d: palette.symbolPath(map, 64), "data-value": c.us,
        transform: `translate(${x(c.at).toFixed(1)},${y(c.us).toFixed(1)})`,
        "data-tip": `${map} at ${c.at} ${xName}\n${fixed(c.us, 2)} \u00B5s, median of n = ${c.runs}` }))));
  }
  const counts = (map: string): string => {
    const ns = [...new Set(costs.filter((c) => c.map === map).map((c) => c.runs))].sort((a, b) => a - b);
    return `n = ${ns.length > 1 ? `${ns[0]} to ${ns[ns.length - 1]}` : ns[0]} each`;
  };
  return figureOf(id, title, note, root, legend(maps.map((map) => ({ planner: map, count: counts(map) })), palette),
    () => csv(["map", xName, yName, "n"], costs.map((c) => [c.map, c.at, c.us, c.runs])));
}

function growthSection(costs: Cost[]): HTMLElement {
  const maps = [...new Set(costs.map((c) => c.map))];
  const exponents = maps.map((map) =>
    `${map} ${fixed(exponentOf(costs.filter((c) => c.map === map)), 2)}`).join(", ");
  return linesOf("growth", "Does a scan cost more when more is known?", "scans of other ground known before",
    costs, `Exponent of the cost in the scans known (0 is flat, 1 grows with the map): ${exponents}. ` +
    "The same scans of new ground every time. Times rise when caches are cold; voronaut-micro-check counts instructions.");
}

function logSection(logs: MappedLog[], costs: Cost[]): HTMLElement {
  const us = (log: MappedLog): number => costs.find((c) => c.map === log.name)?.us ?? NaN;
  const whole = (n: number): string => n.toLocaleString("en");
  return el("section", { id: "lidar", "aria-label": "Recorded lidar" },
    el("h2", {}, "Recorded lidar"),
    el("p", {}, "Corrected poses, ranges up to 20 m. Grey: returns of the scans (a share of them); in colour: the " +
      "points the map keeps, one colour per cluster (eight colours, used again); line: the way of the sensor."),
    tableOf(["log", "scans", "returns", "dropped", "points kept", "clusters", "\u00B5s per scan"],
      logs.map((log) => [log.name, whole(log.scans), whole(log.return_count), whole(log.invalid),
        whole(log.points.x.length), whole(log.clusters), fixed(us(log), 1)]), 0),
    el("div", { class: "plots" }, ...logs.map(drawLog)));
}

function drawMapping(container: HTMLElement, results: MappingData): void {
  const forest = costsOf(results.micro, "mapping/forest");
  const growth = costsOf(results.micro, "mapping/growth");
  const lidar = costsOf(results.micro, "mapping/lidar");
  const machine = results.micro.context ?? {};
  const fact = (name: string, value: unknown): HTMLElement | null =>
    value === undefined ? null : el("span", {}, `${name} `, el("b", {}, el("bdi", {}, String(value))));
  container.replaceChildren(
    el("header", {}, el("div", { class: "facts" }, fact("date", machine.date), fact("cores", machine.num_cpus),
      fact("MHz", machine.mhz_per_cpu), fact("Google Benchmark built as", machine.library_build_type))),
    forest.length === 0 ? el("p", {}, "No entries mapping/forest/... in the file.") :
      el("section", { id: "cost", "aria-label": "Cost of a scan" },
        el("h2", {}, "What one scan costs"),
        el("p", {}, "A vehicle among random circles, every map fed the same returns. CPU time on this machine; the " +
          "ratio is the rival's time over the base's: below 1 the rival is faster. A map that only counts hits does " +
          "one addition per return, and answers nothing but whether a cell was hit: read the last two columns."),
        costTable(forest),
        el("div", { class: "plots" },
          linesOf("cost-by-rays", "Cost of a scan by its rays", "rays per scan", forest,
            "Both axes are logarithmic."),
          growth.length > 0 ? growthSection(growth) : null)),
    results.logs.length > 0 ? logSection(results.logs, lidar) :
      el("p", { class: "note" }, "No recorded lidar: give the folder of data sets with --data or VORONAUT_DATA."));
}

// A page of a run's report.
export function mappingSection(results: MappingData): HTMLElement {
  const place = el("div");
  drawMapping(place, results);
  return place;
}

// The page of `voronaut report micro.json`.
export function buildMappingPage(page: HTMLElement, results: MappingResults): void {
  const place = el("main", { id: "overview" });
  page.replaceChildren(el("header", {}, el("h1", { id: "title" }, el("bdi", {}, results.title))), place);
  drawMapping(place, results);
}
