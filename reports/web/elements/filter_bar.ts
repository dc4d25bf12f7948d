// What is shown: a scenario group, a vehicle, some of the planners. It is the legend too.
import type { Report } from "../data/data";
import { allChosen, choose, chosen } from "./chosen";
import { el, nameOf, select } from "./dom";
import { Palette } from "./palette";
import type { Filter } from "../data/sample";

// As the address says; what it names and is not there is left out.
export function chosenFilter(report: Report): Filter {
  const known = (key: string, values: string[]): string => values.includes(chosen(key)) ? chosen(key) : "";
  const without = new Set(allChosen("without"));
  return { group: known("group", report.groups), vehicle: known("vehicle", report.vehicles),
    planners: new Set(report.planners.filter((p) => !without.has(p))) };
}

function plannerChip(planner: string, report: Report, palette: Palette, filter: Filter, changed: () => void): HTMLElement {
  const chip = el("button", { type: "button", class: `chip ${palette.className(planner)}`,
    "aria-pressed": String(filter.planners.has(planner)), title: `Show or hide ${planner}` }, palette.swatch(planner), nameOf(planner));
  chip.addEventListener("click", () => {
    if (!filter.planners.delete(planner)) filter.planners.add(planner);
    chip.setAttribute("aria-pressed", String(filter.planners.has(planner)));
    choose("without", ...report.planners.filter((p) => !filter.planners.has(p)));
    changed();
  });
  return chip;
}

export function filterBar(
  report: Report, palette: Palette, filter: Filter, changed: () => void
): HTMLElement {
  const choice = (label: string, values: string[], key: "group" | "vehicle"): HTMLElement | null =>
    values.length < 2 ? null : select(label,
      [{ value: "", text: "all" }, ...values.map((v) => ({ value: v, text: v }))], filter[key],
      (v) => { filter[key] = v; choose(key, v); changed(); });
  return el("div", { class: "filters", role: "group", "aria-label": "What is shown" },
    ...report.planners.map((p) => plannerChip(p, report, palette, filter, changed)),
    el("span", { class: "space" }),
    choice("Scenarios", report.groups, "group"),
    choice("Vehicle", report.vehicles, "vehicle"));
}
