// One moment of one trial on a canvas: the true world faint, what is known by then, what is seen now,
// the plan, and the way so far coloured by speed.
import type { Trial, World } from "../data/data";
import { failed, outcomeSign } from "../data/outcomes";
import { bodyWidth_m, footprintAt, hullsOf, kSpeedBins, Point, rayEnds, searchedEdges, speedRamp } from "./replay_geometry";
import { Layers } from "./replay_layers";
import { Trace } from "../data/trace";

export interface Ink {
  bg: string; ink: string; soft: string; line: string; obstacle: string; edge: string;
  hull: string; ray: string; subgoal: string; search: string; tube: string;
}

export function readInk(): Ink {
  const style = getComputedStyle(document.documentElement);
  const get = (name: string): string => style.getPropertyValue(name).trim();
  return {
    bg: get("--bg"), ink: get("--ink"), soft: get("--soft"), line: get("--line"),
    obstacle: get("--obstacle"), edge: get("--obstacle-edge"), hull: get("--hull"),
    ray: get("--ray"), subgoal: get("--subgoal"), search: get("--search"), tube: get("--tube"),
  };
}

export class Painter {
  private readonly context: CanvasRenderingContext2D;
  private scale = 1;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly world: World,
              private readonly trace: Trace, private readonly trial: Trial,
              private readonly speedMax: number, private readonly extent: World["bounds"]) {
    this.context = canvas.getContext("2d") as CanvasRenderingContext2D;
    const [x0, y0, x1, y1] = extent;
    canvas.style.aspectRatio = `${x1 - x0} / ${y1 - y0}`;
  }

  // around_m: half the side of what is shown around the vehicle, 0 for the whole world.
  paint(k: number, layers: Layers, ink: Ink, planner: string, around_m: number): void {
    this.begin(k, ink, around_m);
    if (layers.truth) this.paintTruth(ink);
    if (layers.rays) this.paintRays(k, ink);
    if (layers.tube) this.paintTube(k, ink);
    if (layers.search) this.paintSearch(k, ink);
    if (layers.known) this.paintKnown(k, ink);
    if (layers.hulls) this.paintHulls(k, ink);
    if (layers.plan) this.paintPlan(k, ink, planner);
    if (layers.trail) this.paintTrail(k);
    this.paintPlaces(ink);
    this.paintBody(k, ink, planner);
  }

  // Metres, y up, 1 px of the page = 1 / scale metres.
  private begin(k: number, ink: Ink, around_m: number): void {
    const { canvas, context } = this;
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth || 320;
    const height = canvas.clientHeight || 320;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const { x_m, y_m } = this.trace.frames;
    const high_m = around_m * height / width;
    const [x0, , x1, y1] = around_m > 0
      ? [x_m[k] - around_m, y_m[k] - high_m, x_m[k] + around_m, y_m[k] + high_m] : this.extent;
    this.scale = width / (x1 - x0);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = ink.bg;
    context.fillRect(0, 0, canvas.width, canvas.height);
    const s = this.scale * ratio;
    context.setTransform(s, 0, 0, -s, -x0 * s, y1 * s);
    context.lineJoin = "round";
    context.lineCap = "round";
  }

  private px(pixels: number): number {
    return pixels / this.scale;
  }

  private polyline(points: Iterable<Point>, closed: boolean): void {
    const { context } = this;
    context.beginPath();
    for (const [x, y] of points) context.lineTo(x, y);
    if (closed) context.closePath();
  }

  private flat(points: ArrayLike<number>): Point[] {
    return Array.from({ length: points.length / 2 }, (_, i) => [points[2 * i], points[2 * i + 1]]);
  }

  private disc(x: number, y: number, r: number): void {
    this.context.beginPath();
    this.context.arc(x, y, r, 0, 2 * Math.PI);
  }

  // Solids that overlap or touch as one: all run counter-clockwise, so that one path of them covers their
  // union, and the halves of their outlines that lie in it.
  private paintSolids(ink: Ink): void {
    const { context, world } = this;
    context.beginPath();
    for (const [x, y, r] of world.circles) {
      context.moveTo(x + r, y);
      context.arc(x, y, r, 0, 2 * Math.PI);
    }
    for (const polygon of world.polygons) {
      this.flat(polygon).forEach(([x, y], i) => (i > 0 ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.closePath();
    }
    context.globalAlpha = 0.55;
    context.lineWidth = this.px(2);
    context.stroke();
    context.globalAlpha = 1;
    context.fillStyle = ink.bg;
    context.fill();
    context.globalAlpha = 0.55;
    context.fillStyle = ink.obstacle;
    context.fill();
  }

  private paintTruth(ink: Ink): void {
    const { context, world } = this;
    context.strokeStyle = ink.edge;
    this.paintSolids(ink);
    context.lineWidth = this.px(2.5);
    for (const segment of world.segments) {
      this.polyline(this.flat(segment), false);
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  private paintRays(k: number, ink: Ink): void {
    const { context, trace } = this;
    const { ends, hit } = rayEnds(trace, k);
    if (ends.length === 0) return;
    const here: Point = [trace.frames.x_m[k], trace.frames.y_m[k]];
    context.fillStyle = ink.ray;
    context.strokeStyle = ink.ray;
    context.globalAlpha = 0.16;
    this.polyline([here, ...ends], true);
    context.fill();
    context.globalAlpha = 0.35;
    context.lineWidth = this.px(0.7);
    context.beginPath();
    const every = Math.max(1, Math.round(ends.length / 24));
    for (let i = 0; i < ends.length; i += every) {
      context.moveTo(...here);
      context.lineTo(...ends[i]);
    }
    context.stroke();
    context.globalAlpha = 1;
    ends.forEach(([x, y], i) => {
      if (!hit[i]) return;
      this.disc(x, y, this.px(1.8));
      context.fill();
    });
  }

  private paintKnown(k: number, ink: Ink): void {
    const { context, trace } = this;
    context.fillStyle = ink.ink;
    const size = this.px(2.4);
    const known = Math.min(trace.frames.known[k], trace.known_points.length / 2);
    for (let i = 0; i < known; ++i) {
      context.fillRect(trace.known_points[2 * i] - size / 2, trace.known_points[2 * i + 1] - size / 2,
        size, size);
    }
  }

  private paintHulls(k: number, ink: Ink): void {
    const { context, trace } = this;
    context.strokeStyle = ink.hull;
    context.lineWidth = this.px(1.3);
    context.setLineDash([this.px(4), this.px(3)]);
    for (const hull of hullsOf(trace, k)) {
      this.polyline(hull, true);
      context.stroke();
    }
    context.setLineDash([]);
  }

  // What the planner's latest search looked at: a roadmap's edges or its trees.
  private paintSearch(k: number, ink: Ink): void {
    const { context } = this;
    context.strokeStyle = ink.search;
    context.lineWidth = this.px(0.9);
    context.beginPath();
    for (const [ax, ay, bx, by] of searchedEdges(this.trace, k)) {
      context.moveTo(ax, ay);
      context.lineTo(bx, by);
    }
    context.stroke();
  }

  // The body swept along the governor's track: its width around the track's corners.
  private paintTube(k: number, ink: Ink): void {
    const { context, trace } = this;
    const track = this.flat(trace.frames.tube[k]);
    if (track.length === 0) return;
    context.strokeStyle = ink.tube;
    for (const [width, alpha] of [[bodyWidth_m(trace), 0.28], [this.px(1.2), 1]]) {
      context.lineWidth = width;
      context.globalAlpha = alpha;
      this.polyline(track, false);
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  private paintPlan(k: number, ink: Ink, planner: string): void {
    const { context, trace } = this;
    const plan = trace.plans[trace.frames.plan[k]];
    context.strokeStyle = planner;
    context.lineWidth = this.px(1.6);
    if (plan) {
      context.setLineDash([this.px(7), this.px(4)]);
      this.polyline(this.flat(plan), false);
      context.stroke();
      context.setLineDash([]);
    }
    const [x, y] = [trace.frames.target_x_m[k], trace.frames.target_y_m[k]];
    const arm = this.px(6);
    context.strokeStyle = ink.subgoal;
    context.lineWidth = this.px(2);
    context.beginPath();
    context.moveTo(x - arm, y - arm);
    context.lineTo(x + arm, y + arm);
    context.moveTo(x - arm, y + arm);
    context.lineTo(x + arm, y - arm);
    context.stroke();
  }

  private paintTrail(k: number): void {
    const { context, trace: { frames } } = this;
    const ramp = speedRamp();
    context.lineWidth = this.px(3.4);
    for (let i = 1; i <= k; ++i) {
      const share = frames.speed_m_s[i] / Math.max(this.speedMax, 1e-9);
      context.strokeStyle = ramp[Math.min(kSpeedBins - 1, Math.round(share * (kSpeedBins - 1)))];
      context.beginPath();
      context.moveTo(frames.x_m[i - 1], frames.y_m[i - 1]);
      context.lineTo(frames.x_m[i], frames.y_m[i]);
      context.stroke();
    }
  }

  private paintPlaces(ink: Ink): void {
    const { context, world } = this;
    context.fillStyle = ink.bg;
    context.strokeStyle = ink.ink;
    context.lineWidth = this.px(1.6);
    this.disc(world.start[0], world.start[1], this.px(5));
    context.fill();
    context.stroke();
    const [x, y] = world.goal;
    const d = this.px(6.5);
    this.polyline([[x - d, y], [x, y + d], [x + d, y], [x, y - d]], true);
    context.fill();
    context.stroke();
  }

  private paintBody(k: number, ink: Ink, planner: string): void {
    const { context, trace } = this;
    const f = trace.frames;
    const [x, y] = [f.x_m[k], f.y_m[k]];
    context.strokeStyle = ink.soft;
    context.lineWidth = this.px(1);
    context.setLineDash([this.px(2), this.px(3)]);
    this.disc(x, y, trace.clearance_min_m);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = planner;
    context.strokeStyle = ink.bg;
    context.lineWidth = this.px(1.5);
    const corners = footprintAt(trace, k);
    if (corners.length > 0 && trace.body_radius_m > this.px(4)) this.polyline(corners, true);
    else this.disc(x, y, Math.max(trace.body_radius_m, this.px(4)));
    context.fill();
    context.stroke();
    const nose = Math.max(trace.body_radius_m, this.px(4)) + this.px(7);
    context.strokeStyle = planner;
    context.lineWidth = this.px(2.5);
    this.polyline([[x, y], [x + nose * f.heading_x[k], y + nose * f.heading_y[k]]], false);
    context.stroke();
    if (k === f.count - 1 && failed(this.trial.outcome)) this.paintSign(x, y, ink);
  }

  private paintSign(x: number, y: number, ink: Ink): void {
    const { context, scale } = this;
    context.save();
    context.translate(x, y);
    context.scale(1 / scale, -1 / scale);
    context.font = "bold 22px sans-serif";
    context.textAlign = "center";
    context.lineWidth = 4;
    context.strokeStyle = ink.bg;
    context.fillStyle = ink.subgoal;
    context.strokeText(outcomeSign(this.trial.outcome), 0, 8);
    context.fillText(outcomeSign(this.trial.outcome), 0, 8);
    context.restore();
  }
}
