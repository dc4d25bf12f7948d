// How the trials of each planner spread. Vehicles are compared with their like only: one set of plots
// for each.
import { boxPlot } from "../plots/box_plot";
import type { Report, Trial } from "../data/data";
import { el } from "../elements/dom";
import { ecdfPlot } from "../plots/ecdf_plot";
import { Palette } from "../elements/palette";
import { Filter, samplesOf } from "../data/sample";

function plotsOf(report: Report, palette: Palette, filter: Filter, suffix: string): HTMLElement {
  const samples = samplesOf(report, filter);
  const value = (column: string) => (t: Trial): number => t[column] as number;
  const box = (id: string, title: string, xName: string, column: string, note: string,
               logarithmic: boolean): HTMLElement =>
    boxPlot(`${id}${suffix}`, title, xName, note, samples, (t) => Number(t[column]), palette, logarithmic);
  return el("div", { class: "plots" },
    ecdfPlot(`path-ratio${suffix}`, "How long are the paths?",
      "path ratio: flown / shortest possible", samples, value("path_ratio"), palette, 1),
    ecdfPlot(`duration${suffix}`, "How long does it take?", "time to goal in s (simulated)", samples,
      value("duration_s"), palette, 0),
    box("clearance", "How close do they come?", "smallest clearance of a trial in m, centre to surface",
      "clearance_min_m", "", false),
    box("speed", "How fast do they fly?", "mean speed of a trial in m/s", "speed_mean_m_s", "", false),
    box("planning-time", "What does planning cost?",
      "mean planning time per scan in \u00B5s (logarithmic)", "planning_time_us_mean",
      "Measured on this machine.", true),
    box("state-checks", "How much work is it?", "state checks per trial (logarithmic)", "state_checks",
      "Counted, the same on every machine; a planner that asks for none has no row.", true));
}

export function distributions(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const vehicles = report.vehicles.filter((v) => !filter.vehicle || v === filter.vehicle);
  return el("div", {}, ...vehicles.flatMap((vehicle, i) => [
    vehicles.length > 1 ? el("h3", { class: "vehicle" }, vehicle) : null,
    plotsOf(report, palette, { ...filter, vehicle }, i === 0 ? "" : `-${i + 1}`),
  ]));
}
