// Traces as columns of SI numbers (reports/trace/trace_json.h).
import type { Report } from "./data";

export interface Frames {
  count: number;
  t_s: Float64Array;
  x_m: Float64Array;
  y_m: Float64Array;
  speed_m_s: Float64Array;
  heading_x: Float64Array;
  heading_y: Float64Array;
  tilt_rad: Float64Array;
  clearance_m: Float64Array;
  actuators: Float64Array[];
  planning_time_us: Float64Array;
  target_x_m: Float64Array;
  target_y_m: Float64Array;
  mode: Float64Array;
  plan: Float64Array;
  search: Float64Array;  // the latest by then, -1: none was kept
  replan: Float64Array;
  solve_end: Float64Array;
  share: Float64Array;
  tube: Float64Array[];  // x, y, x, y ...
  known: Float64Array;
  range_m: Float64Array[];
}

export interface Trace {
  trial_id: string;
  static: boolean;  // nobody flew, the frames walk along the path at 1 m/s
  body_radius_m: number;
  footprint: Float64Array;  // x, y, ... of its corners, x forward; empty: the disc
  clearance_min_m: number;
  field_of_view_rad: number;
  max_range_m: number;
  modes: string[];
  replan_reasons: string[];
  solve_ends: string[];
  plans: Float64Array[];  // x, y, x, y ...
  known_points: Float64Array;
  cluster_of: number[];  // when the point became known
  merges: number[];      // frame, from, into, ...: from that frame on
  hulls: Float64Array[];
  edges: { ends: Float64Array; first: Float64Array; last: Float64Array };  // x, y, x, y of each
  searches: number;
  kept_searches: number;  // the first of them
  frames: Frames;
}

const kVersion = 4;

function undelta(column: (number | null)[], scale: number): Float64Array {
  const out = new Float64Array(column.length);
  let sum = 0;
  column.forEach((delta, i) => {
    sum += delta ?? 0;
    out[i] = delta === null ? NaN : sum / scale;
  });
  return out;
}

function points(flat: number[], perMetre: number, x_m = 0, y_m = 0): Float64Array {
  const out = new Float64Array(flat.length);
  const sum = [Math.round(x_m * perMetre) || 0, Math.round(y_m * perMetre) || 0];
  flat.forEach((delta, i) => {
    sum[i % 2] += delta;
    out[i] = sum[i % 2] / perMetre;
  });
  return out;
}

function ranges(scan: number[], maxRange: number): Float64Array {
  const out = new Float64Array(scan.length);
  let code = 0;
  scan.forEach((delta, i) => {
    code += delta;
    out[i] = code < 0 ? maxRange : code / 100;
  });
  return out;
}

// The layout is that of trace_json.h.
function decodeTrace(json: string): Trace {
  const raw = JSON.parse(json);
  if (raw.version !== kVersion) throw new Error(`its trace has version ${raw.version}, not ${kVersion}`);
  const f = raw.frames;
  const vx = undelta(f.vx_mm_s, 1000);
  const vy = undelta(f.vy_mm_s, 1000);
  const x_m = undelta(f.x_mm, 1000);
  const y_m = undelta(f.y_mm, 1000);
  const first = undelta(raw.edges.first, 1);
  const metres = (flat: number[]): Float64Array => points(flat, 1000);
  return {
    trial_id: raw.trial_id,
    static: raw.static,
    body_radius_m: raw.body_radius_m,
    footprint: metres(raw.footprint ?? []),
    clearance_min_m: raw.clearance_min_m,
    field_of_view_rad: raw.field_of_view_rad,
    max_range_m: raw.max_range_m,
    modes: raw.modes,
    replan_reasons: raw.replan_reasons,
    solve_ends: raw.solve_ends,
    plans: raw.plans.map(metres),
    known_points: metres(raw.known_points),
    cluster_of: raw.cluster_of,
    merges: raw.merges,
    hulls: raw.hulls.map(metres),
    edges: { ends: points(raw.edges.ends_cm, 100), first,
      last: first.map((from, i) => from + raw.edges.on[i]) },
    searches: raw.searches,
    kept_searches: raw.kept_searches,
    frames: {
      count: f.t_ms.length,
      t_s: undelta(f.t_ms, 1000),
      x_m,
      y_m,
      speed_m_s: vx.map((v, i) => Math.hypot(v, vy[i])),
      heading_x: undelta(f.heading_x_1e4, 1e4),
      heading_y: undelta(f.heading_y_1e4, 1e4),
      tilt_rad: undelta(f.tilt_1e4, 1e4),
      clearance_m: undelta(f.clearance_mm, 1000),
      actuators: [0, 1, 2, 3].map((k) => undelta(f[`actuator${k}_1e2`], 100)),
      planning_time_us: undelta(f.planning_time_100ns, 10),
      target_x_m: undelta(f.target_x_mm, 1000),
      target_y_m: undelta(f.target_y_mm, 1000),
      mode: undelta(f.mode, 1),
      plan: undelta(f.plan, 1),
      search: undelta(f.search, 1),
      replan: undelta(f.replan, 1),
      solve_end: undelta(f.solve_end, 1),
      share: undelta(f.share_1e3, 1e3),
      tube: f.tube_mm.map((flat: number[], i: number) => points(flat, 1000, x_m[i], y_m[i])),
      known: undelta(f.known, 1),
      range_m: f.range_cm.map((scan: number[]) => ranges(scan, raw.max_range_m)),
    },
  };
}

async function inflate(base64: string): Promise<string> {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).text();
}

const decoded = new Map<string, Promise<Trace>>();

export function hasTrace(report: Report, trialId: string): boolean {
  return Object.prototype.hasOwnProperty.call(report.traces, trialId);
}

// Decoded once; a few dozen stay in memory.
export function loadTrace(report: Report, trialId: string): Promise<Trace> {
  let trace = decoded.get(trialId);
  if (!trace) {
    trace = inflate(report.traces[trialId]).then(decodeTrace);
    decoded.set(trialId, trace);
    if (decoded.size > 64) {
      decoded.delete(decoded.keys().next().value as string);
    }
  }
  return trace;
}
