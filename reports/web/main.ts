import { kGoal, readReport, Report, Trial, vehicleOf } from "./data";
import { button, el, percent, select } from "./dom";
import { failuresSection } from "./failures";
import { Filter, overview } from "./overview";
import { Palette } from "./palette";
import { ecdfPlot, Sample, stripPlot } from "./plots";
import { manifestEntries, provenanceSection } from "./provenance";
import { Replay } from "./replay";
import { scenesSection } from "./scenes";

function preferredTheme(): string {
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

function setTheme(theme: string): void {
  document.documentElement.dataset.theme = theme;
  window.dispatchEvent(new Event("themechange"));
}

function toggleTheme(): void {
  setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
}

// The facts of the manifest a reader looks for first, found by the last part of their name.
const kHeadlineFacts = ["version", "commit", "compiler", "build_type", "cpu", "seed", "started_utc", "command"];

function header(report: Report): HTMLElement {
  const reached = report.trials.filter((t) => t.outcome === kGoal).length;
  const facts: [string, string][] = [
    ["trials", String(report.trials.length)],
    ["reached the goal", `${reached} (${percent(report.trials.length ? reached / report.trials.length : null)})`],
    ["planners", String(report.planners.length)],
    ["scenarios", String(new Set(report.trials.map((t) => t.scenario)).size)],
  ];
  for (const wanted of kHeadlineFacts) {
    const found = manifestEntries(report.manifest)
      .find(([path, value]) => path.split(".").pop()?.replace(/^git_/, "") === wanted && value.length < 120);
    if (found) facts.push([wanted, wanted === "commit" ? found[1].slice(0, 12) : found[1]]);
  }
  return el("header", {}, el("h1", { id: "title" }, el("bdi", {}, report.title)),
    el("div", { class: "facts" }, ...facts.map(([name, value]) =>
      el("span", {}, `${name} `, el("b", {}, el("bdi", {}, value))))));
}

// Vehicles are compared with their like only: one set of plots for each.
function distributions(report: Report, palette: Palette, filter: Filter): HTMLElement {
  const vehicles = report.vehicles.filter((v) => !filter.vehicle || v === filter.vehicle);
  return el("div", {}, ...vehicles.flatMap((vehicle, i) => [
    vehicles.length > 1 ? el("h3", { class: "vehicle" }, vehicle) : null,
    plotsOf(report, palette, filter.group, vehicle, i === 0 ? "" : `-${i + 1}`),
  ]));
}

function plotsOf(report: Report, palette: Palette, group: string, vehicle: string,
                 suffix: string): HTMLElement {
  const kept = report.trials.filter((t) => (!group || t.scenario_group === group) &&
    vehicleOf(t) === vehicle);
  const samples: Sample[] = report.planners
    .map((planner) => ({ planner, trials: kept.filter((t) => t.planner === planner) }))
    .filter((s) => s.trials.length > 0);
  const value = (column: string) => (t: Trial): number => t[column] as number;
  return el("div", { class: "plots" },
    ecdfPlot(`path-ratio${suffix}`, "How long are the paths?",
      "path ratio: flown / shortest possible", samples, value("path_ratio"), palette, 1),
    ecdfPlot(`duration${suffix}`, "How long does it take?", "time to goal in s (simulated)", samples,
      value("duration_s"), palette, 0),
    stripPlot(`clearance${suffix}`, "How close do they come?",
      "smallest clearance of a trial in m, centre to surface", "", samples,
      value("clearance_min_m"), palette, false),
    stripPlot(`speed${suffix}`, "How fast do they fly?", "mean speed of a trial in m/s", "", samples,
      value("speed_mean_m_s"), palette, false),
    stripPlot(`planning-time${suffix}`, "What does planning cost?",
      "mean planning time per scan in \u00B5s (logarithmic)", "Measured on this machine.", samples,
      value("planning_time_us_mean"), palette, true),
    stripPlot(`state-checks${suffix}`, "How much work is it?",
      "state checks per trial (logarithmic)",
      "Counted, the same on every machine; a planner that asks for none has no row.", samples,
      (t) => Number(t.state_checks), palette, true));
}

interface Part {
  id: string;
  title: string;
  nav: string;
  draw: (filter: Filter) => HTMLElement;
}

function build(report: Report, page: HTMLElement): void {
  const palette = new Palette(report.planners);
  const filter: Filter = { group: "", vehicle: "" };
  const replay = new Replay(report, palette);
  const parts: Part[] = [
    { id: "overview", title: "Who arrives, and how well", nav: "Overview",
      draw: (f) => overview(report, palette, f) },
    { id: "distributions", title: "Distributions", nav: "Distributions",
      draw: (f) => distributions(report, palette, f) },
    { id: "scenes", title: "Scenarios", nav: "Scenarios",
      draw: (f) => scenesSection(report, palette, f) },
    { id: "replay", title: "Replay", nav: "Replay", draw: () => replay.element },
    { id: "failures", title: "Failures", nav: "Failures",
      draw: (f) => failuresSection(report, palette, f) },
    { id: "provenance", title: "Where this comes from", nav: "Provenance",
      draw: () => provenanceSection(report) },
  ];
  const places = parts.map(() => el("div"));
  const redraw = (): void => {
    parts.forEach((part, i) => places[i].replaceChildren(part.draw(filter)));
  };
  const choice = (label: string, values: string[], set: (v: string) => void): HTMLElement | null =>
    values.length < 2 ? null : select(label,
      [{ value: "", text: "all" }, ...values.map((v) => ({ value: v, text: v }))], "",
      (v) => { set(v); redraw(); });
  page.replaceChildren(
    header(report),
    el("nav", { "aria-label": "Sections" },
      ...parts.map((part) => el("a", { href: `#${part.id}` }, part.nav)),
      el("span", { class: "space" }),
      choice("Scenarios", report.groups, (v) => { filter.group = v; }),
      choice("Vehicle", report.vehicles, (v) => { filter.vehicle = v; }),
      button("Light / dark", "Switch between light and dark", toggleTheme)),
    el("main", {}, ...parts.map((part, i) => el("section", { id: part.id, "aria-label": part.title },
      el("h2", {}, part.title), places[i]))));
  redraw();
  replay.start();
}

function start(): void {
  setTheme(preferredTheme());
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => setTheme(preferredTheme()));
  const page = document.getElementById("page") as HTMLElement;
  try {
    build(readReport(document.getElementById("report-data")?.textContent ?? ""), page);
    document.documentElement.dataset.ready = "yes";
    document.documentElement.dataset.drawnMs = performance.now().toFixed(0);
  } catch (error) {
    page.replaceChildren(el("p", { role: "alert" }, `This report cannot be drawn: ${String(error)}`));
    throw error;
  }
}

start();
