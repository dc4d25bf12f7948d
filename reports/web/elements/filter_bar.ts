// What is shown: a scenario group, a vehicle, some of the planners. It is the legend too.
import type { Report } from "../data/data";
import { el, nameOf, select } from "./dom";
import { Palette } from "./palette";
import type { Filter } from "../data/sample";

function plannerChip(planner: string, palette: Palette, filter: Filter, changed: () => void): HTMLElement {
  const chip = el("button", { type: "button", class: `chip ${palette.className(planner)}`,
    "aria-pressed": "true", title: `Show or hide ${planner}` }, palette.swatch(planner), nameOf(planner));
  chip.addEventListener("click", () => {
    if (!filter.planners.delete(planner)) filter.planners.add(planner);
    chip.setAttribute("aria-pressed", String(filter.planners.has(planner)));
    changed();
  });
  return chip;
}

export function filterBar(
  report: Report, palette: Palette, filter: Filter, changed: () => void
): HTMLElement {
  const choice = (label: string, values: string[], set: (v: string) => void): HTMLElement | null =>
    values.length < 2 ? null : select(label,
      [{ value: "", text: "all" }, ...values.map((v) => ({ value: v, text: v }))], "",
      (v) => { set(v); changed(); });
  return el("div", { class: "filters", role: "group", "aria-label": "What is shown" },
    ...report.planners.map((p) => plannerChip(p, palette, filter, changed)),
    el("span", { class: "space" }),
    choice("Scenarios", report.groups, (v) => { filter.group = v; }),
    choice("Vehicle", report.vehicles, (v) => { filter.vehicle = v; }));
}
