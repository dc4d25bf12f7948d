// How the trials of each planner spread: a plot for every statistic that asks a question. Vehicles are
// compared with their like only: one set of plots for each.
import { boxPlot } from "../plots/box_plot";
import type { Report, Statistic, Trial } from "../data/data";
import { el } from "../elements/dom";
import { ecdfPlot } from "../plots/ecdf_plot";
import { Palette } from "../elements/palette";
import { Filter, Sample, samplesOf } from "../data/sample";

// What reached the goal is drawn over all trials, so that failures are seen: as a curve that ends below
// 1. A value without unit is a ratio to what is best: no less than 1.
function plotOf(
  report: Report, statistic: Statistic, samples: Sample[], palette: Palette, suffix: string
): HTMLElement {
  const { column, question, logarithmic, of_reached } = statistic;
  const { about, unit } = report.columns[column];
  const axis = `${about}${unit ? `, ${unit}` : ""}${logarithmic ? " (logarithmic)" : ""}`;
  const value = (t: Trial): number => Number(t[column]);
  return of_reached
    ? ecdfPlot(`${column}${suffix}`, question, axis, samples, value, palette, unit ? 0 : 1)
    : boxPlot(`${column}${suffix}`, question, axis,
      logarithmic ? "A planner without a value above 0 has no row." : "", samples, value, palette, logarithmic);
}

function hasValues(statistic: Statistic, samples: Sample[]): boolean {
  return samples.some(({ trials }) => trials.some((t) => !Number.isNaN(Number(t[statistic.column]))));
}

export function distributions(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const vehicles = report.vehicles.filter((v) => !filter.vehicle || v === filter.vehicle);
  const asking = report.summary.statistics.filter((s) => s.question !== "");
  return el("div", {}, ...vehicles.flatMap((vehicle, i) => {
    const samples = samplesOf(report, { ...filter, vehicle });
    return [
      vehicles.length > 1 ? el("h3", { class: "vehicle" }, vehicle) : null,
      el("div", { class: "plots" }, ...asking.filter((s) => hasValues(s, samples)).map((s) =>
        plotOf(report, s, samples, palette, i === 0 ? "" : `-${i + 1}`))),
    ];
  }));
}
