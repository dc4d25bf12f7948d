// What others published of the BARN challenge's courses, and this run beside it.
import { plannerCell, rateCell, spreadText } from "../elements/cells";
import type { Difference, Estimate, Published, Standing } from "../data/data";
import { el, fixed, nameOf } from "../elements/dom";
import { Palette } from "../elements/palette";
import type { Filter } from "../data/sample";
import { table } from "../elements/table";

function estimateCell(estimate: Estimate, digits: number): HTMLElement {
  const spread = spreadText(estimate, digits);
  return el("span", {}, fixed(estimate.value, digits), spread && el("small", {}, spread));
}

function standingsTable(rows: Standing[], palette: Palette): HTMLElement {
  return table("Who stands where", [
    { heading: "planner", text: true, cell: (r) => r.vehicle ? plannerCell(r.name, palette) : nameOf(r.name),
      order: (r) => r.name },
    { heading: "vehicle", text: true, cell: (r) => r.vehicle ? nameOf(r.vehicle) : el("i", {}, "published"),
      order: (r) => r.vehicle },
    { heading: "runs", cell: (r) => String(r.reached.n), order: (r) => r.reached.n },
    { heading: "arrived", cell: (r) => rateCell(r.reached), order: (r) => r.reached.value ?? NaN },
    { heading: "collided", cell: (r) => rateCell(r.collided), order: (r) => r.collided.value ?? NaN },
    { heading: "score,\nmean", title: "mean over the worlds of each world's mean; at most 0.5",
      cell: (r) => estimateCell(r.score, 3), order: (r) => r.score.value ?? NaN },
    { heading: "time,\nmean, s", title: "mean over the worlds in which it arrived",
      cell: (r) => estimateCell(r.time_s, 1), order: (r) => r.time_s.value ?? NaN },
  ], rows, (r) => r.vehicle ? palette.className(r.name) : "");
}

function differencesTable(rows: Difference[], palette: Palette): HTMLElement {
  return table("Score, ours less theirs, paired by world", [
    { heading: "planner", text: true, cell: (r) => plannerCell(r.planner, palette), order: (r) => r.planner },
    { heading: "vehicle", text: true, cell: (r) => nameOf(r.vehicle), order: (r) => r.vehicle },
    { heading: "against", text: true, cell: (r) => nameOf(r.method), order: (r) => r.method },
    { heading: "difference", cell: (r) => estimateCell(r.score, 3), order: (r) => r.score.value ?? NaN },
    { heading: "p (Holm)", cell: (r) => (r.p_holm ?? 1) < 0.0001 ? "< 0.0001" : fixed(r.p_holm, 4),
      order: (r) => r.p_holm ?? NaN },
  ], rows, (r) => palette.className(r.planner));
}

export function publishedSection(published: Published, palette: Palette, filter: Filter): HTMLElement {
  const keep = (planner: string, vehicle: string): boolean =>
    filter.planners.has(planner) && (!filter.vehicle || filter.vehicle.split(", ")[0] === vehicle);
  return el("div", {},
    el("p", {}, `Over the ${published.worlds} worlds that all have met. Shares are over runs, with Wilson's 95 % ` +
      "interval; score and time are over the worlds' means, their intervals a bootstrap over worlds. What was " +
      "published was driven in another simulator, with errors that this one has only where its suite asks for them."),
    standingsTable(published.standings.filter((r) => !r.vehicle || keep(r.name, r.vehicle)), palette),
    differencesTable(published.differences.filter((r) => keep(r.planner, r.vehicle)), palette));
}
