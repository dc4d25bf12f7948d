// Every trial that did not reach the goal, with its reason.
import { hasTrace, kGoal, Report, Trial, vehicleOf } from "./data";
import { button, el, fixed, nameOf } from "./dom";
import { replayLink } from "./links";
import { outcomeSign, outcomeWords, Palette } from "./palette";
import { Column, table } from "./table";

const kMostRows = 200;
const kBeforeTheEnd_s = 2;

function replayCell(report: Report, trial: Trial): Node | string {
  if (!hasTrace(report, trial.trial_id)) return "\u2013";
  const t = Math.max(0, (Number.isNaN(trial.duration_s) ? 0 : trial.duration_s) - kBeforeTheEnd_s);
  return el("a", { href: replayLink([trial.trial_id], t) }, "watch");
}

function columnsFor(report: Report, palette: Palette): Column<Trial>[] {
  return [
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

export function failuresSection(
  report: Report, palette: Palette, filter: { group: string; vehicle: string }
): HTMLElement {
  const failed = report.trials.filter((t) => t.outcome !== kGoal &&
    (!filter.group || t.scenario_group === filter.group) &&
    (!filter.vehicle || vehicleOf(t) === filter.vehicle))
    .sort((a, b) => a.outcome.localeCompare(b.outcome) || a.planner.localeCompare(b.planner) ||
      a.scenario.localeCompare(b.scenario, "en", { numeric: true }));
  if (failed.length === 0) return el("p", {}, "Every trial reached the goal.");
  const place = el("div");
  const show = (count: number): void => {
    place.replaceChildren(
      table(`${failed.length} trials did not reach the goal`, columnsFor(report, palette),
        failed.slice(0, count), (t) => palette.className(t.planner)),
      count < failed.length
        ? button(`Show all ${failed.length}`, "List every failed trial", () => show(failed.length))
        : "");
  };
  show(kMostRows);
  return place;
}
