// The five situations of the quadrotor paper's figure 9 in its order, with the numbers beside.
import { Report, Trial, vehicleOf } from "../data/data";
import { plannerCell } from "../elements/cells";
import { el, fixed, nameOf, select } from "../elements/dom";
import { waysButtons } from "./drawn_ways";
import { replayLink } from "../elements/links";
import { outcomeText } from "../elements/outcome_text";
import { Palette } from "../elements/palette";
import { Filter, keeps } from "../data/sample";
import { firstPerPlanner, Scene, scenesOf } from "../data/scene";
import { sceneDrawing, whenSeen } from "./scenes";
import { Column, table } from "../elements/table";

const kScenes: [scenario: string, caption: string][] = [
  ["paper-between", "(a) between obstacles"],
  ["paper-left", "(b) to the left of obstacles"],
  ["paper-right", "(c) to the right of obstacles"],
  ["paper-near-goal", "(d) an obstacle near the target"],
  ["paper-even", "(e) evenly located obstacles"],
];

function scenesOfFigure(report: Report): Scene[] {
  const scenes = scenesOf(report);
  return kScenes.flatMap(([name]) => scenes.filter((s) => s.scenario === name));
}

export function hasFigure9(report: Report): boolean {
  const present = new Set(scenesOfFigure(report).map((s) => s.scenario));
  return present.size === kScenes.length;
}

function numbers(scenes: Scene[], chosen: (scene: Scene) => Trial[], palette: Palette): HTMLElement {
  const rows = scenes.flatMap((scene) => chosen(scene));
  const captions = new Map(kScenes);
  const number = (heading: string, decimals: number, value: (t: Trial) => number): Column<Trial> => ({
    heading, cell: (t) => fixed(value(t), decimals), order: value,
  });
  return table("The numbers", [
    { heading: "scene", text: true, order: (t) => captions.get(t.scenario) ?? "",
      cell: (t) => captions.get(t.scenario) ?? t.scenario },
    { heading: "planner", text: true, order: (t) => t.planner, cell: (t) => plannerCell(t.planner, palette) },
    { heading: "outcome", text: true, order: (t) => t.outcome,
      cell: (t) => el("span", { title: t.reason }, outcomeText(t.outcome)) },
    { heading: "modes in order", text: true, order: (t) => t.modes, cell: (t) => t.modes || "\u2013" },
    number("path, m", 2, (t) => t.path_length_m),
    number("path ratio", 3, (t) => t.path_ratio),
    number("time, s", 2, (t) => t.duration_s),
    number("mean speed, m/s", 2, (t) => t.speed_mean_m_s),
    number("smallest clearance, m", 2, (t) => t.clearance_smallest_m),
    number("mean clearance, m", 2, (t) => Number(t.clearance_mean_m)),
  ], rows, (t) => palette.className(t.planner));
}

function sceneFigure(report: Report, scene: Scene, trials: Trial[], palette: Palette): HTMLElement {
  const caption = new Map(kScenes).get(scene.scenario) as string;
  const place = el("div", { class: "waiting" }, "drawing \u2026");
  const figure: HTMLElement = el("figure", { "data-figure9": scene.scenario }, place,
    el("figcaption", {}, el("h3", {}, caption),
      el("a", { href: replayLink(trials.slice(0, 4).map((t) => t.trial_id)) }, "replay"),
      ...waysButtons(report, trials, "figure9", caption, () => figure.querySelector<SVGElement>("svg.world"))));
  whenSeen(figure, () => {
    void sceneDrawing(report, scene, trials, trials[0]?.planner ?? "", palette)
      .then((picture) => place.replaceWith(picture));
  });
  return figure;
}

export function figure9Section(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const all = scenesOfFigure(report).filter((s) => !filter.vehicle || s.vehicle === filter.vehicle);
  const vehicles = report.vehicles.filter((v) => all.some((s) => s.vehicle === v));
  const place = el("div");
  const show = (vehicle: string): void => {
    const scenes = all.filter((s) => s.vehicle === vehicle);
    const chosen = (scene: Scene): Trial[] => firstPerPlanner(scene)
      .filter((t) => keeps({ ...filter, group: "" }, t) && vehicleOf(t) === vehicle);
    place.replaceChildren(
      el("div", { class: "figure9" }, ...scenes.map((s) => sceneFigure(report, s, chosen(s), palette))),
      numbers(scenes, chosen, palette));
  };
  show(vehicles[0] ?? "");
  return el("div", {},
    el("p", {}, "From (0, 0, 0), rising to 1 m, to (10, 10): circles of 0.5 and 1 m, 2.5 m/s, " +
      "\u03B3 = 0.5 m, field of view \u00B145\u00B0, range 2.5 m. Where the obstacles stand is our " +
      "reconstruction, for the paper's text does not say; it states no number to compare with, only that " +
      "all modes were implemented. Dots and dashed hulls: what the first planner shown had seen."),
    vehicles.length > 1 && el("div", { class: "controls" },
      select("Vehicle", vehicles.map((v) => ({ value: v, text: v })), vehicles[0], show)), place);
}
