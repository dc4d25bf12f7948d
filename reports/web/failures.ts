// Every trial that did not reach the goal, with its reason.
import { byName, kGoal, Report, Trial, vehicleOf } from "./data";
import { button, el, fixed, nameOf } from "./dom";
import { replayLink } from "./links";
import { outcomeSign, outcomeWords, Palette } from "./palette";
import { Scene, scenesOf } from "./scene";
import { sceneDrawing, whenSeen } from "./scenes";
import { Column, table } from "./table";
import { hasTrace } from "./trace";

const kMostRows = 200;
const kBeforeTheEnd_s = 2;

function linkToTheEnd(trial: Trial): string {
  const end_s = Number.isNaN(trial.duration_s) ? 0 : trial.duration_s;
  return replayLink([trial.trial_id], Math.max(0, end_s - kBeforeTheEnd_s));
}

function replayCell(report: Report, trial: Trial): Node | string {
  if (!hasTrace(report, trial.trial_id)) return "\u2013";
  return el("a", { href: linkToTheEnd(trial) }, "watch");
}

// The way of one failed trial, small; a press replays its last seconds.
function thumbnail(report: Report, scene: Scene, trial: Trial, palette: Palette): HTMLElement {
  const link = el("a", { class: "thumbnail", href: linkToTheEnd(trial),
    "aria-label": `replay of ${trial.planner} in ${trial.scenario}` });
  whenSeen(link, () => {
    void sceneDrawing(report, scene, [trial], trial.planner, palette)
      .then((picture) => link.replaceChildren(picture));
  });
  return link;
}

function columnsFor(report: Report, palette: Palette, scenes: Map<string, Scene>): Column<Trial>[] {
  return [
    { heading: "picture", text: true, cell: (t) => {
      const scene = scenes.get(t.trial_id);
      return scene ? thumbnail(report, scene, t, palette) : "\u2013";
    } },
    { heading: "outcome", text: true, order: (t) => t.outcome,
      cell: (t) => el("span", { class: "bad" }, `${outcomeSign(t.outcome)} ${outcomeWords(t.outcome)}`) },
    { heading: "planner", text: true, order: (t) => t.planner,
      cell: (t) => el("span", {}, palette.swatch(t.planner), " ", nameOf(t.planner)) },
    { heading: "scenario", text: true, order: (t) => t.scenario, cell: (t) => nameOf(t.scenario) },
    { heading: "vehicle", text: true, order: vehicleOf, cell: (t) => nameOf(vehicleOf(t)) },
    { heading: "repetition", order: (t) => Number(t.repetition), cell: (t) => t.repetition },
    { heading: "after, s", order: (t) => t.duration_s, cell: (t) => fixed(t.duration_s, 2) },
    { heading: "at x, y in m", cell: (t) => Number.isNaN(t.end_x_m) ? "\u2013"
      : `${fixed(t.end_x_m, 2)}, ${fixed(t.end_y_m, 2)}` },
    { heading: "reason", text: true, wrap: true, order: (t) => t.reason,
      cell: (t) => el("bdi", {}, t.reason) },
    { heading: "replay", text: true, cell: (t) => replayCell(report, t) },
    { heading: "trial", text: true, cell: (t) => el("code", {}, nameOf(t.trial_id)) },
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
      heading: `${outcomeSign(outcome)} ${outcomeWords(outcome)}`,
      cell: (p) => String(count(p, outcome)), order: (p) => count(p, outcome),
    })),
  ], planners, (p) => palette.className(p));
}

export function failuresSection(
  report: Report, palette: Palette, filter: { group: string; vehicle: string }
): HTMLElement {
  const failed = report.trials.filter((t) => t.outcome !== kGoal &&
    (!filter.group || t.scenario_group === filter.group) &&
    (!filter.vehicle || vehicleOf(t) === filter.vehicle))
    .sort((a, b) => a.outcome.localeCompare(b.outcome) || a.planner.localeCompare(b.planner) ||
      a.scenario.localeCompare(b.scenario, "en", { numeric: true }));
  if (failed.length === 0) return el("p", {}, "Every trial reached the goal.");
  const scenes = new Map(scenesOf(report).flatMap((scene) =>
    scene.trials.map((t): [string, Scene] => [t.trial_id, scene])));
  const place = el("div");
  const show = (count: number): void => {
    place.replaceChildren(
      table(`${failed.length} trials did not reach the goal`, columnsFor(report, palette, scenes),
        failed.slice(0, count), (t) => palette.className(t.planner)),
      count < failed.length
        ? button(`Show all ${failed.length}`, "List every failed trial", () => show(failed.length))
        : "");
  };
  show(kMostRows);
  return el("div", {}, classTable(failed, palette),
    el("p", { class: "note" }, el("code", {}, "voronaut replay DIR TRIAL"), " flies a trial again and " +
      "says whether it is the same to the last bit."), place);
}
