import { comparisonSection } from "./pages/comparison";
import { MappingData, Published, readReport, Report } from "./data/data";
import { followAddress, readChoices } from "./elements/chosen";
import { distributions } from "./pages/distributions";
import { el, percent } from "./elements/dom";
import { failuresSection } from "./pages/failures";
import { figure9Section, hasFigure9 } from "./pages/figure9";
import { chosenFilter, filterBar } from "./elements/filter_bar";
import { pageOf } from "./elements/links";
import { buildMappingPage, mappingSection } from "./pages/mapping";
import { failed } from "./data/outcomes";
import { overview } from "./pages/overview";
import { Palette } from "./elements/palette";
import { manifestEntries, provenanceSection } from "./pages/provenance";
import { publishedSection } from "./pages/published";
import { Replay } from "./replay/replay";
import type { Filter } from "./data/sample";
import { scenesSection } from "./pages/scenes";
import { sweepSection } from "./plots/sweep_plots";
import { sweepsOf } from "./data/sweep";
import { followSystemTheme, themeButton } from "./elements/theme";
import { startTooltips } from "./elements/tooltip";

// The facts of the manifest a reader looks for first, found by the last part of their name.
const kHeadlineFacts = ["mixed_builds", "version", "commit", "compiler", "build_type", "processor", "seed", "started_utc"];

function header(report: Report): HTMLElement {
  const reached = report.trials.filter((t) => !failed(t.outcome)).length;
  const facts: [string, string][] = [
    ["trials", String(report.trials.length)],
    ["reached the goal", `${reached} (${percent(report.trials.length ? reached / report.trials.length : null)})`],
    ["planners", String(report.planners.length)],
    ["scenarios", String(new Set(report.trials.map((t) => t.scenario)).size)],
  ];
  const entries = manifestEntries(report.manifest);
  for (const wanted of kHeadlineFacts) {
    const found = entries
      .find(([path, value]) => path.split(".").pop()?.replace(/^git_/, "") === wanted && value.length < 120);
    if (found) facts.push([wanted, wanted === "commit" ? found[1].slice(0, 12) : found[1]]);
  }
  return el("header", {}, el("h1", { id: "title" }, el("bdi", {}, report.title)),
    el("div", { class: "facts" }, ...facts.map(([name, value]) =>
      el("span", {}, `${name} `, el("b", {}, el("bdi", {}, value))))));
}

// One page of the report; drawn when it is first looked at, and again when the filter has changed.
interface Page {
  id: string;
  title: string;
  nav: string;
  draw: (filter: Filter) => HTMLElement;
}

function pagesOf(report: Report, palette: Palette, replay: Replay): Page[] {
  const all = { group: "", vehicle: "", planners: new Set(report.planners) };
  const pages: (Page | false)[] = [
    { id: "overview", title: "Who arrives, and how well", nav: "Overview",
      draw: (f) => overview(report, palette, f) },
    { id: "distributions", title: "Distributions", nav: "Distributions",
      draw: (f) => distributions(report, palette, f) },
    sweepsOf(report, all).length > 0 && { id: "sweeps", title: "Parameter sweeps", nav: "Sweeps",
      draw: (f) => sweepSection(report, palette, f) },
    { id: "scenes", title: "Scenarios", nav: "Scenarios",
      draw: (f) => scenesSection(report, palette, f) },
    hasFigure9(report) && { id: "figure9", title: "The quadrotor paper's figure 9", nav: "Figure 9",
      draw: (f) => figure9Section(report, palette, f) },
    { id: "replay", title: "Replay", nav: "Replay", draw: () => replay.element },
    { id: "failures", title: "Failures", nav: "Failures",
      draw: (f) => failuresSection(report, palette, f) },
    report.comparison !== null && { id: "comparison", title: "Against another run", nav: "Comparison",
      draw: (f) => comparisonSection(report, palette, f) },
    report.published !== null && { id: "published", title: "Beside published results", nav: "Published",
      draw: (f) => publishedSection(report.published as Published, palette, f) },
    report.mapping !== null && { id: "mapping", title: "The mapping step", nav: "Mapping",
      draw: () => mappingSection(report.mapping as MappingData) },
    { id: "provenance", title: "Where this comes from", nav: "Provenance",
      draw: () => provenanceSection(report) },
  ];
  return pages.filter((p): p is Page => p !== false);
}

function build(report: Report, root: HTMLElement): void {
  const palette = new Palette(report.planners);
  const filter = chosenFilter(report);
  const replay = new Replay(report, palette);
  const pages = pagesOf(report, palette, replay);
  const stale = new Set(pages.map((p) => p.id));
  const links = pages.map((p) => el("a", { href: `#${p.id}` }, p.nav));
  const places = pages.map(() => el("div"));
  const sections = pages.map((p, i) => el("section", { id: `page-${p.id}`, "aria-labelledby": `head-${p.id}`,
    hidden: "" }, el("h2", { id: `head-${p.id}`, tabindex: "-1" }, p.title), places[i]));
  const show = (): void => {
    const current = pageOf(location.hash, pages.map((p) => p.id));
    pages.forEach((page, i) => {
      sections[i].hidden = page.id !== current;
      if (page.id !== current) {
        links[i].removeAttribute("aria-current");
        return;
      }
      links[i].setAttribute("aria-current", "page");
      if (stale.delete(page.id)) places[i].replaceChildren(page.draw(filter));
      if (page.id === "replay") replay.shown();
    });
  };
  const changed = (): void => {
    pages.forEach((p) => stale.add(p.id));
    show();
  };
  root.replaceChildren(
    header(report),
    el("div", { class: "bar-top" },
      el("nav", { "aria-label": "Pages" }, ...links, el("span", { class: "space" }), themeButton()),
      filterBar(report, palette, filter, changed)),
    el("main", {}, ...sections));
  show();
  window.addEventListener("hashchange", () => {
    followAddress();
    show();
    if (!location.hash.startsWith("#replay")) window.scrollTo(0, 0);
  });
}

function start(): void {
  readChoices();
  followSystemTheme();
  startTooltips();
  const root = document.getElementById("page") as HTMLElement;
  try {
    const text = document.getElementById("report-data")?.textContent ?? "";
    const data = JSON.parse(text);
    if (data.micro) buildMappingPage(root, data);
    else build(readReport(text), root);
    document.documentElement.dataset.ready = "yes";
    document.documentElement.dataset.drawnMs = performance.now().toFixed(0);
  } catch (error) {
    root.replaceChildren(el("p", { role: "alert" }, `This report cannot be drawn: ${String(error)}`));
    throw error;
  }
}

start();
