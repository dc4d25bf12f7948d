// Up to four trials of one scene on one clock.
import { Report, Trial, World } from "../data/data";
import { keptOfRun } from "../data/kept";
import { standAt } from "../elements/chosen";
import { button, checkbox, el, fixed, nameOf, select } from "../elements/dom";
import { readReplayLink, replayLink, ReplayPlace } from "../elements/links";
import { outcomeText } from "../elements/outcome_text";
import { Palette } from "../elements/palette";
import { Ink, Painter, readInk } from "./replay_canvas";
import { factsAt } from "./replay_facts";
import { frameAt, speedRamp } from "./replay_geometry";
import { everyLayer, layerSwitches } from "./replay_layers";
import { commandOf } from "../elements/repeat_command";
import { extentOf, firstPerPlanner, Scene, scenesOf } from "../data/scene";
import { modeStrip } from "./mode_strip";
import { actuatorsOf, kQuantities, Series, timeSeries } from "./time_series";
import { loadTrace, Trace } from "../data/trace";

const kMostPanels = 4;
const kScan_s = 0.05;
const kSpeeds = [0.25, 0.5, 1, 2, 4, 8];
// Metres around the vehicle; 0 is the whole world.
const kViews = [["0", "whole world"], ["6", "6 m around"], ["3", "3 m around"], ["1.5", "1.5 m around"]];

interface Panel {
  trial: Trial;
  trace: Trace;
  painter: Painter;
  canvas: HTMLCanvasElement;
  readout: HTMLElement;
  figure: HTMLElement;
}

function sceneName(scene: Scene): string {
  return `${scene.scenario} \u00B7 ${scene.vehicle} \u00B7 repetition ${scene.trials[0].repetition}`;
}

function trialName(trial: Trial, scene: Scene): string {
  const repeated = scene.trials.some((t) => t.planner === trial.planner && t !== trial);
  return repeated ? `${trial.planner}, repetition ${trial.repetition}` : trial.planner;
}

export class Replay {
  readonly element: HTMLElement;
  private readonly scenes: Scene[];
  private scene: Scene | null = null;
  private panels: Panel[] = [];
  private series: Series[] = [];
  private t_s = 0;
  private end_s = 1;
  private speed = 1;
  private around_m = 0;
  private playing = false;
  private lastTick = 0;
  private opening = 0;  // a later opening overtakes an earlier one that still decodes
  private ink: Ink;
  private readonly layers = everyLayer();

  private readonly choices = el("div", { class: "controls" });
  private readonly panelGrid = el("div", { class: "panels" });
  private readonly seriesGrid = el("div", { class: "plots series" });
  private readonly slider = el("input", { type: "range", min: "0", max: "1", step: "0.01",
    "aria-label": "time in seconds" });
  private readonly clockText = el("output", { id: "replay-clock" });
  private readonly playButton = button("\u25B6 Play", "Play or pause (space)", () => this.toggle());

  constructor(private readonly report: Report, private readonly palette: Palette) {
    this.scenes = scenesOf(report);
    this.ink = readInk();
    this.element = this.build();
    window.addEventListener("themechange", () => {
      this.ink = readInk();
      this.paint();
    });
    window.addEventListener("resize", () => this.paint());
    document.addEventListener("keydown", (event) => this.onKey(event));
  }

  // The page is looked at now: opens what the address names, else what was open, else the first scene.
  shown(): void {
    if (this.follow()) return;
    const first = this.scenes[0];
    if (this.scene) this.paint();
    else if (first) void this.open(first, firstPerPlanner(first).slice(0, kMostPanels), 0);
  }

  private follow(): boolean {
    const place = readReplayLink(location.hash);
    const scene = place && this.scenes.find((s) =>
      s.trials.some((t) => t.trial_id === place.trialIds[0]));
    if (!place || !scene) return false;
    void this.openPlace(scene, place);
    return true;
  }

  private async openPlace(scene: Scene, place: ReplayPlace): Promise<void> {
    const trials = place.trialIds
      .map((id) => scene.trials.find((t) => t.trial_id === id))
      .filter((t): t is Trial => t !== undefined);
    await this.open(scene, trials.slice(0, kMostPanels), place.t_s ?? 0);
    document.getElementById("page-replay")?.scrollIntoView();
    if (place.t_s === null) this.setPlaying(true);
  }

  private build(): HTMLElement {
    if (this.scenes.length === 0) return el("p", { class: "soft" }, "No trial with a stored trace.");
    this.slider.addEventListener("input", () => {
      this.setPlaying(false);
      this.seek(Number(this.slider.value));
    });
    const kept = keptOfRun(this.report);
    return el("div", {},
      kept && el("p", { class: "note" }, `${kept}.`),
      this.choices,
      el("div", { class: "clock" },
        button("|\u25C0", "To the start (Home)", () => this.seek(0)),
        button("\u2212", "One scan back (left arrow)", () => this.step(-1)),
        this.playButton,
        button("+", "One scan on (right arrow)", () => this.step(1)),
        button("\u25B6|", "To the end (End)", () => this.seek(this.end_s)),
        select("playback", kSpeeds.map((v) => ({ value: String(v), text: `${v}\u00D7` })), "1",
          (v) => { this.speed = Number(v); }),
        select("view", kViews.map(([value, text]) => ({ value, text })), "0",
          (v) => { this.around_m = Number(v); this.paint(); }),
        this.slider, this.clockText,
        button("Link", "Put this moment into the address", () => this.writeLink())),
      this.panelGrid,
      el("div", { class: "controls layers", role: "group", "aria-label": "Layers" },
        ...layerSwitches(this.layers, this.report.plannedOnly, () => this.paint()),
        this.report.plannedOnly ? null : this.speedLegend()),
      el("p", { class: "note" }, this.report.plannedOnly ? "Nobody flies: the disc walks along the path at 1 m/s. " +
        "Dotted circle: the clearance it plans with; thin lines: what the search looked at. Space plays, arrows step, " +
        "with shift a second, Home and End jump; press a curve to go there." : "Disc or polygon: the body; dotted circle: the clearance it plans with; cross: " +
        "the setpoint; dashed line: the plan; dashed outlines: clusters, grouped as the map grouped them " +
        "at that moment; thin lines: what the planner's latest search looked at (of VoronoiRoadmap the Voronoi " +
        "edges wide enough to pass); band: what the body sweeps if it brakes after this scan's course, proved free. Space plays, arrows step, with shift a second, Home and End jump; press a curve to go there."),
      this.seriesGrid);
  }

  private readonly speedEnd = el("span", { class: "soft" });

  private speedLegend(): HTMLElement {
    const canvas = el("canvas", { width: "96", height: "10", "aria-hidden": "true" });
    const context = canvas.getContext("2d") as CanvasRenderingContext2D;
    speedRamp().forEach((colour, i, ramp) => {
      context.fillStyle = colour;
      context.fillRect(i * 96 / ramp.length, 0, 96 / ramp.length + 1, 10);
    });
    return el("span", { class: "control" }, el("span", {}, "0"), canvas, this.speedEnd);
  }

  private async open(scene: Scene, trials: Trial[], t_s: number): Promise<void> {
    const ticket = ++this.opening;
    this.setPlaying(false);
    let traces: Trace[];
    try {
      traces = await Promise.all(trials.map((t) => loadTrace(this.report, t.trial_id)));
    } catch (error) {
      this.panelGrid.replaceChildren(`This trial cannot be replayed: ${String(error)}`);
      return;
    }
    if (ticket !== this.opening) return;
    this.scene = scene;
    const speedMax = traces.reduce((m, trace) => trace.frames.speed_m_s.reduce(
      (a, b) => (b > a ? b : a), m), 0);
    this.speedEnd.textContent = `${fixed(speedMax, 1)} m/s`;
    this.end_s = traces.reduce((m, trace) => Math.max(m, trace.frames.t_s[trace.frames.count - 1]), 0.01);
    this.slider.max = String(this.end_s);
    const extent = extentOf(scene.world, traces);
    this.panels = trials.map((trial, i) => this.makePanel(trial, traces[i], speedMax, extent));
    this.panelGrid.replaceChildren(...this.panels.map((panel) => panel.figure));
    const seek = (t: number): void => this.seek(t);
    this.series = [
      ...[...kQuantities, actuatorsOf(traces)].filter((q) => !q.flown || !this.report.plannedOnly).map((q) => timeSeries(q, trials, traces, this.end_s, this.palette, seek)),
      this.report.plannedOnly ? null : modeStrip(trials, traces, this.end_s, this.palette, seek),
    ].filter((s): s is Series => s !== null);
    this.seriesGrid.replaceChildren(...this.series.map((s) => s.element));
    this.showChoices();
    this.seek(t_s);
  }

  private makePanel(trial: Trial, trace: Trace, speedMax: number,
                    extent: World["bounds"]): Panel {
    const canvas = el("canvas", { role: "img" });
    const readout = el("dl");
    const figure = el("figure", { class: this.palette.className(trial.planner),
      "data-trial": trial.trial_id },
      el("figcaption", {}, this.palette.swatch(trial.planner), el("h3", {}, nameOf(trial.planner)),
        el("span", { title: trial.reason }, outcomeText(trial.outcome))),
      canvas, readout, commandOf(this.report, trial));
    const world = (this.scene as Scene).world;
    return { trial, trace, canvas, readout, figure,
      painter: new Painter(canvas, world, trace, trial, speedMax, extent) };
  }

  private showChoices(): void {
    const scene = this.scene as Scene;
    const chosen = new Set(this.panels.map((panel) => panel.trial));
    this.choices.replaceChildren(
      select("Scene", this.scenes.map((s) => ({ value: s.key, text: sceneName(s) })), scene.key,
        (key) => {
          const next = this.scenes.find((s) => s.key === key) as Scene;
          void this.open(next, firstPerPlanner(next).slice(0, kMostPanels), 0);
        }),
      ...scene.trials.map((trial) => {
        const box = checkbox(el("span", {}, this.palette.swatch(trial.planner), " ",
          nameOf(trialName(trial, scene))), chosen.has(trial), (on) => {
          const kept = scene.trials.filter((t) => t === trial ? on : chosen.has(t));
          if (kept.length > 0) void this.open(scene, kept.slice(-kMostPanels), this.t_s);
          else this.showChoices();
        });
        box.classList.add(this.palette.className(trial.planner));
        return box;
      }));
  }

  private seek(t_s: number): void {
    this.t_s = Math.min(this.end_s, Math.max(0, t_s));
    this.slider.value = String(this.t_s);
    this.clockText.textContent = `${this.t_s.toFixed(2)} of ${this.end_s.toFixed(2)} s`;
    for (const series of this.series) series.setTime(this.t_s);
    this.paint();
  }

  private step(direction: number): void {
    this.setPlaying(false);
    this.seek((Math.round(this.t_s / kScan_s) + direction) * kScan_s);
  }

  private paint(): void {
    for (const panel of this.panels) {
      const k = frameAt(panel.trace, this.t_s);
      const colour = getComputedStyle(panel.figure).getPropertyValue("--planner").trim();
      panel.painter.paint(k, this.layers, this.ink, colour, this.around_m);
      this.describe(panel, k);
    }
  }

  private describe(panel: Panel, k: number): void {
    const facts = factsAt(panel.trace, k);
    panel.readout.replaceChildren(...facts.map(([name, value]) =>
      el("div", name === "governor" ? { class: "wide" } : {}, el("dt", {}, name), el("dd", { title: value }, el("bdi", {}, value)))));
    panel.canvas.setAttribute("aria-label", `${panel.trial.planner} at ${this.t_s.toFixed(2)} s: ` +
      facts.map(([name, value]) => `${name} ${value}`).join(", "));
    panel.figure.dataset.frame = String(k);
  }

  private toggle(): void {
    if (!this.playing && this.t_s >= this.end_s) this.seek(0);
    this.setPlaying(!this.playing);
  }

  private setPlaying(playing: boolean): void {
    if (playing === this.playing) return;
    this.playing = playing;
    this.playButton.textContent = playing ? "\u2759\u2759 Pause" : "\u25B6 Play";
    this.playButton.setAttribute("aria-pressed", String(playing));
    if (playing) {
      this.lastTick = performance.now();
      requestAnimationFrame((now) => this.tick(now));
    }
  }

  private tick(now: number): void {
    if (!this.playing) return;
    this.seek(this.t_s + Math.max(0, now - this.lastTick) / 1000 * this.speed);
    this.lastTick = now;
    if (this.t_s >= this.end_s) this.setPlaying(false);
    else requestAnimationFrame((next) => this.tick(next));
  }

  private writeLink(): void {
    standAt(replayLink(this.panels.map((panel) => panel.trial.trial_id), this.t_s));
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    const typing = ["SELECT", "INPUT"].includes(target.tagName) && target !== this.slider;
    if (typing || event.ctrlKey || event.metaKey || event.altKey || !this.onScreen()) return;
    if (event.key === " " && target.tagName !== "BUTTON") this.toggle();
    else if (event.key === "ArrowRight") this.jump(event.shiftKey ? 1 : 0, 1);
    else if (event.key === "ArrowLeft") this.jump(event.shiftKey ? -1 : 0, -1);
    else if (event.key === "Home") this.seek(0);
    else if (event.key === "End") this.seek(this.end_s);
    else return;
    event.preventDefault();
  }

  private jump(seconds: number, scans: number): void {
    if (seconds === 0) {
      this.step(scans);
    } else {
      this.setPlaying(false);
      this.seek(this.t_s + seconds);
    }
  }

  private onScreen(): boolean {
    const box = this.panelGrid.getBoundingClientRect();
    return box.height > 0 && box.bottom > 0 && box.top < window.innerHeight;
  }
}
