// Every trial that did not reach the goal, with its reason.
import { byName, Report, Trial, vehicleOf, World } from "../data/data";
import { button, el, fixed, nameOf, select } from "../elements/dom";
import { replayLink } from "../elements/links";
import { failed as isFailed, outcomeWords } from "../data/outcomes";
import { outcomeText } from "../elements/outcome_text";
import { Palette } from "../elements/palette";
import { commandOf } from "../elements/repeat_command";
import { Filter, keeps } from "../data/sample";
import { Scene, scenesOf } from "../data/scene";
import { sceneDrawing, whenSeen } from "./scenes";
import { Column, table } from "../elements/table";
import { hasTrace } from "../data/trace";

const kMostRows = 200;
const kBeforeTheEnd_s = 2;
const kAround_m = 3.5;  // of the place where a trial ended, on its thumbnail

function linkToTheEnd(trial: Trial): string {
  const end_s = Number.isNaN(trial.duration_s) ? 0 : trial.duration_s;
  return replayLink([trial.trial_id], Math.max(0, end_s - kBeforeTheEnd_s));
}

function replayCell(report: Report, trial: Trial): Node | string {
  if (!hasTrace(report, trial.trial_id)) return "\u2013";
  return el("a", { href: linkToTheEnd(trial) }, "watch");
}

// Where one trial failed, and what was known there; a press replays its last seconds.
function thumbnail(report: Report, scene: Scene, trial: Trial, palette: Palette): HTMLElement {
  const link = el("a", { class: "thumbnail", href: linkToTheEnd(trial),
    "aria-label": `replay of ${trial.planner} in ${trial.scenario}` });
  whenSeen(link, () => {
    void sceneDrawing(report, scene, [trial], trial.planner, palette, endOf(trial))
      .then((picture) => link.replaceChildren(picture));
  });
  return link;
}

function endOf(trial: Trial): World["bounds"] | null {
  return Number.isNaN(trial.end_x_m) ? null : [trial.end_x_m - kAround_m, trial.end_y_m - kAround_m,
    trial.end_x_m + kAround_m, trial.end_y_m + kAround_m];
}

function columnsFor(report: Report, palette: Palette, scenes: Map<string, Scene>): Column<Trial>[] {
  return [
    { heading: "where it went wrong", text: true, cell: (t) => {
      const scene = scenes.get(t.trial_id);
      return scene ? thumbnail(report, scene, t, palette) : "no trace kept";
    } },
    { heading: "outcome", text: true, order: (t) => t.outcome,
      cell: (t) => outcomeText(t.outcome) },
    { heading: "planner", text: true, order: (t) => t.planner,
      cell: (t) => el("span", {}, palette.swatch(t.planner), " ", nameOf(t.planner)) },
    { heading: "scenario, vehicle, repetition", text: true, order: (t) => t.scenario,
      cell: (t) => el("span", {}, nameOf(t.scenario),
        el("small", {}, nameOf(`${vehicleOf(t)}, repetition ${t.repetition}`))) },
    ...(report.plannedOnly ? [] : [
      { heading: "after, s", order: (t: Trial) => t.duration_s, cell: (t: Trial) => fixed(t.duration_s, 2) }]),
    { heading: "reason", text: true, wrap: true, order: (t) => t.reason,
      cell: (t) => el("bdi", {}, t.reason) },
    { heading: "replay", text: true, cell: (t) => replayCell(report, t) },
    { heading: "fly it again", text: true, cell: (t) => commandOf(report, t) },
  ];
}

// How often each planner failed in each way.
function classTable(failed: Trial[], palette: Palette): HTMLElement {
  const planners = [...new Set(failed.map((t) => t.planner))].sort(byName);
  const outcomes = [...new Set(failed.map((t) => t.outcome))].sort(byName);
  const count = (planner: string, outcome: string): number =>
    failed.filter((t) => t.planner === planner && t.outcome === outcome).length;
  return table("How they failed", [
    { heading: "planner", text: true, order: (p) => p,
      cell: (p) => el("span", {}, palette.swatch(p), " ", nameOf(p)) },
    ...outcomes.map((outcome): Column<string> => ({
      heading: outcomeText(outcome),
      cell: (p) => String(count(p, outcome)), order: (p) => count(p, outcome),
    })),
  ], planners, (p) => palette.className(p));
}

export function failuresSection(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const failed = report.trials.filter((t) => isFailed(t.outcome) && keeps(filter, t))
    .sort((a, b) => byName(a.outcome, b.outcome) || byName(a.planner, b.planner) ||
      byName(a.scenario, b.scenario));
  if (failed.length === 0) return el("p", {}, "Every trial reached the goal.");
  const scenes = new Map(scenesOf(report).flatMap((scene) =>
    scene.trials.map((t): [string, Scene] => [t.trial_id, scene])));
  const columns = columnsFor(report, palette, scenes);
  const place = el("div");
  const show = (outcome: string, count: number): void => {
    const chosen = failed.filter((t) => !outcome || t.outcome === outcome);
    place.replaceChildren(
      table(`${chosen.length} trials did not reach the goal`, columns, chosen.slice(0, count),
        (t) => palette.className(t.planner)),
      count < chosen.length
        ? button(`Show all ${chosen.length}`, "List every failed trial", () => show(outcome, Infinity))
        : "");
  };
  show("", kMostRows);
  const outcomes = [...new Set(failed.map((t) => t.outcome))].sort(byName);
  return el("div", {}, classTable(failed, palette),
    el("div", { class: "controls" }, select("Ended by",
      [{ value: "", text: "any" }, ...outcomes.map((o) => ({ value: o, text: outcomeWords(o) }))], "",
      (outcome) => show(outcome, kMostRows))), place);
}
