// One drawing per scenario and world: what is there, what was known of it at the end, and the ways.
import { Report, Trial, World } from "../data/data";
import { button, el, fixed, nameOf, select, svg } from "../elements/dom";
import { waysButtons } from "./drawn_ways";
import { failed, outcomeSign, outcomeWords } from "../data/outcomes";
import { outcomeText } from "../elements/outcome_text";
import { Palette } from "../elements/palette";
import { replayLink } from "../elements/links";
import { footprintAt } from "../replay/replay_geometry";
import { Filter, keeps } from "../data/sample";
import { extentOf, firstPerPlanner, Scene, scenesOf } from "../data/scene";
import { arrivedOf, keptOfRun } from "../data/kept";
import { loadTrace, Trace } from "../data/trace";

const kSide = 400;  // of the drawing, in its own units
const kMostAtOnce = 24;

// World metres to drawing units, y up.
export class View {
  readonly scale: number;
  readonly width: number;
  readonly height: number;

  constructor(private readonly bounds: World["bounds"], side: number) {
    const [x0, y0, x1, y1] = bounds;
    this.scale = side / Math.max(x1 - x0, y1 - y0, 1e-9);
    this.width = (x1 - x0) * this.scale;
    this.height = (y1 - y0) * this.scale;
  }

  x(x_m: number): number {
    return (x_m - this.bounds[0]) * this.scale;
  }

  y(y_m: number): number {
    return (this.bounds[3] - y_m) * this.scale;
  }

  path(flat: ArrayLike<number>, closed: boolean): string {
    let d = "";
    for (let i = 0; i + 1 < flat.length; i += 2) {
      d += `${i ? "L" : "M"}${this.x(flat[i]).toFixed(1)} ${this.y(flat[i + 1]).toFixed(1)}`;
    }
    return d && closed ? `${d}Z` : d;
  }

  // Each point as a line of no length, which a round cap makes a dot: one element for thousands.
  dots(flat: ArrayLike<number>): string {
    let d = "";
    for (let i = 0; i + 1 < flat.length; i += 2) {
      d += `M${this.x(flat[i]).toFixed(1)} ${this.y(flat[i + 1]).toFixed(1)}h0`;
    }
    return d;
  }
}

// Solids that overlap or touch as one: what fills them covers the halves of their outlines that lie in others.
function drawSolids(root: SVGElement, world: World, view: View, kind: "outline" | "obstacle"): void {
  for (const [x, y, r] of world.circles) {
    root.append(svg("circle", { class: kind, cx: view.x(x).toFixed(2),
      cy: view.y(y).toFixed(2), r: (r * view.scale).toFixed(2) }));
  }
  const rings = world.polygons.map((polygon) => view.path(polygon, true)).join("");
  if (rings) root.append(svg("path", { class: kind, d: rings }));
}

function drawWorld(root: SVGElement, world: World, view: View): void {
  drawSolids(root, world, view, "outline");
  drawSolids(root, world, view, "obstacle");
  for (const segment of world.segments) {
    root.append(svg("path", { class: "wall", d: view.path(segment, false) }));
  }
  const [x0, y0, x1, y1] = world.bounds;
  root.append(svg("path", { class: "bounds",
    d: view.path([x0, y0, x1, y0, x1, y1, x0, y1], true) }));
}

function drawPlaces(root: SVGElement, world: World, view: View): void {
  for (const [name, [x, y]] of [["start", world.start], ["goal", world.goal]] as const) {
    const right = view.x(x) > view.width - 50;
    root.append(
      name === "start"
        ? svg("circle", { class: "mark", cx: view.x(x), cy: view.y(y), r: 5 })
        : svg("path", { class: "mark", d: `M${view.x(x) - 6} ${view.y(y)}l6 -6l6 6l-6 6z` }),
      svg("text", { class: "place", x: view.x(x) + (right ? -9 : 9),
        y: view.y(y) + (view.y(y) < 24 ? 16 : -7), "text-anchor": right ? "end" : "start" }, name));
  }
}

function drawScale(root: SVGElement, view: View): void {
  const spans = [0.5, 1, 2, 5, 10, 20, 50, 100, 200];
  const metres = spans.find((m) => m * view.scale > 40) ?? 500;
  const y = view.height + 12;
  root.append(
    svg("path", { class: "scale", fill: "none",
      d: `M0 ${y - 4}v4h${(metres * view.scale).toFixed(1)}v-4` }),
    svg("text", { class: "faint", x: metres * view.scale + 6, y: y + 2 }, `${metres} m`));
}

function drawTrack(root: SVGElement, trial: Trial, trace: Trace, view: View, palette: Palette): void {
  const { x_m, y_m, count } = trace.frames;
  const flat = new Float64Array(2 * count);
  for (let i = 0; i < count; ++i) {
    flat[2 * i] = x_m[i];
    flat[2 * i + 1] = y_m[i];
  }
  const [endX, endY] = [x_m[count - 1], y_m[count - 1]];
  const outline = footprintAt(trace, count - 1);
  const g = svg("g", { class: palette.className(trial.planner), "data-trial": trial.trial_id },
    svg("title", {}, `${trial.planner}: ${outcomeWords(trial.outcome)}. ${trial.reason}`),
    svg("path", { class: "track", d: view.path(flat, false),
      "stroke-dasharray": palette.dash(trial.planner) }),
    outline.length > 0 && trace.body_radius_m * view.scale > 2
      ? svg("path", { class: "body", d: view.path(Float64Array.from(outline.flat()), true) })
      : svg("circle", { class: "body", cx: view.x(endX), cy: view.y(endY),
        r: Math.max(2, trace.body_radius_m * view.scale) }));
  if (failed(trial.outcome)) {
    g.append(svg("text", { class: "sign", x: view.x(endX), y: view.y(endY) + 9 },
      outcomeSign(trial.outcome)));
  }
  root.append(g);
}

export async function sceneDrawing(
  report: Report, scene: Scene, trials: Trial[], mapOf: string, palette: Palette,
  part: World["bounds"] | null = null  // null: all that is worth showing
): Promise<SVGElement> {
  const traces = await Promise.all(trials.map((t) => loadTrace(report, t.trial_id)));
  const view = new View(part ?? extentOf(scene.world, traces), kSide);
  const root = svg("svg", { class: "world", role: "img",
    viewBox: `-4 -4 ${view.width + 8} ${view.height + 26}`,
    "aria-label": `${scene.scenario}: true world, what was known, and ${trials.length} ways` });
  drawWorld(root, scene.world, view);
  const known = traces[Math.max(0, trials.findIndex((t) => t.planner === mapOf))];
  if (known) {
    for (const hull of known.hulls) {
      root.append(svg("path", { class: "hull", d: view.path(hull, true) }));
    }
    root.append(svg("path", { class: "known", d: view.dots(known.known_points) }));
  }
  trials.forEach((trial, i) => drawTrack(root, trial, traces[i], view, palette));
  drawPlaces(root, scene.world, view);
  drawScale(root, view);
  return root;
}

function resultText(trial: Trial): string {
  const time = Number.isNaN(trial.duration_s) ? "" : `${fixed(trial.duration_s, 1)} s`;
  if (failed(trial.outcome)) return time && `after ${time}`;
  return [`ratio ${fixed(trial.path_ratio, 3)}`, time].filter((t) => t).join(", ");
}

// Of the world, where the run says so.
function difficultyText(trial: Trial): string {
  const free = trial.free_share >= 0 ? `; ${fixed(100 * trial.free_share, 0)} % free` : "";
  return trial.narrowest_passage_m >= 0
    ? `${free}, narrowest passage ${fixed(trial.narrowest_passage_m, 2)} m` : free;
}

function trialLine(report: Report, trial: Trial, palette: Palette): HTMLElement {
  return el("li", { class: palette.className(trial.planner), title: trial.reason },
    palette.swatch(trial.planner), nameOf(trial.planner),
    outcomeText(trial.outcome),
    el("span", { class: "result soft", title: "this flight; of all in this scenario" },
      [resultText(trial), arrivedOf(report, trial)].filter((t) => t).join("; ")));
}

function sceneCard(report: Report, scene: Scene, shown: Set<string>, mapOf: string,
                   palette: Palette): HTMLElement {
  const trials = firstPerPlanner(scene).filter((t) => shown.has(t.planner));
  const place = el("div", { class: "waiting" }, "drawing \u2026");
  const card: HTMLElement = el("figure", { "data-scene": scene.scenario },
    el("figcaption", {}, el("h3", {}, nameOf(scene.scenario)),
      el("a", { href: replayLink(trials.slice(0, 4).map((t) => t.trial_id)) }, "replay"),
      ...waysButtons(report, trials, "scene", scene.scenario, () => card.querySelector<SVGElement>("svg.world"))),
    place,
    el("p", { class: "note" }, `${scene.vehicle}, repetition ${trials[0].repetition}${difficultyText(trials[0])}`),
    el("ul", {}, ...trials.map((t) => trialLine(report, t, palette))));
  const draw = (): void => {
    void sceneDrawing(report, scene, trials, mapOf, palette)
      .then((picture) => place.replaceWith(picture))
      .catch((error) => place.replaceChildren(`cannot be drawn: ${String(error)}`));
  };
  whenSeen(card, draw);
  return card;
}

// Drawings below the screen wait until they are scrolled to, or the browser has nothing else to do: paper
// shows what is drawn by then.
export function whenSeen(element: Element, action: () => void): void {
  let done = false;
  const once = (): void => {
    if (!done) action();
    done = true;
  };
  const whenIdle = window.requestIdleCallback ?? ((later: () => void) => setTimeout(later, 1000));
  whenIdle(() => {
    if (element.getClientRects().length > 0) once();
  }, { timeout: 2000 });
  const observer = new IntersectionObserver((entries) => {
    if (entries.some((entry) => entry.isIntersecting)) {
      observer.disconnect();
      once();
    }
  }, { rootMargin: "800px" });
  observer.observe(element);
  window.addEventListener("beforeprint", once);
}

export function scenesSection(
  report: Report, palette: Palette, filter: Filter
): HTMLElement {
  const scenes = scenesOf(report).filter((s) => s.trials.some((t) => keeps(filter, t)));
  const drawn = Object.keys(report.traces).length;
  const grid = el("div", { class: "scenes" });
  const more = el("div", { class: "controls" });
  let shown = 0;
  const planners = report.planners.filter((p) => filter.planners.has(p));
  let mapOf = planners[0] ?? "";
  const extend = (): void => {
    const next = scenes.slice(shown, shown + kMostAtOnce);
    grid.append(...next.map((scene) => sceneCard(report, scene, filter.planners, mapOf, palette)));
    shown += next.length;
    more.replaceChildren(shown < scenes.length
      ? button(`Show ${Math.min(kMostAtOnce, scenes.length - shown)} more of ${scenes.length}`,
          "Draw further scenarios", extend)
      : "");
  };
  const redraw = (): void => {
    grid.replaceChildren();
    shown = 0;
    extend();
  };
  extend();
  return el("div", {},
    el("p", {}, report.plannedOnly ? "Grey: the world, known to the planner. Lines: the path that each planner found." :
      "Grey: the true world. Dots: points the range finder returned until the end. Dashed " +
      "outlines: hulls of the clusters they were grouped into. Lines: where each planner flew; a " +
      "sign marks where a trial failed, a disc is the body at the end."),
    keptOfRun(report) && el("p", { class: "note" }, `${keptOfRun(report)}: what is drawn here is of these.`),
    drawn < report.stored_traces && el("p", { class: "note" },
      `${drawn} of ${report.stored_traces} stored trials are drawn and can be replayed here: for every ` +
      "planner and scenario the best, the median and the worst path and each way of failing, first of " +
      "all one world of every scenario. The others are in the results store."),
    !report.plannedOnly && el("div", { class: "controls" },
      select("Points and hulls as known to",
        planners.map((p) => ({ value: p, text: p })), mapOf, (value) => {
          mapOf = value;
          redraw();
        })),
    scenes.length > 0 ? grid : el("p", { class: "soft" }, "No trial with a stored trace."), more);
}
