// What the page was given (reports/report_data.h), and traces as columns of SI numbers
// (reports/trace_json.h).

export interface Estimate {
  value: number | null;
  interval: [number | null, number | null];
  n: number;
}

export interface Rate extends Estimate {
  successes: number;
}

export interface GroupKey {
  scenario_group: string;
  all_scenarios: boolean;
  vehicle: string;
  regulator: string;
}

export interface PlannerSummary extends GroupKey {
  planner: string;
  n: number;
  success: Rate;
  outcomes: Record<string, number>;
  path_ratio_median: Estimate;
  path_ratio_p95: Estimate;
  spl_mean: Estimate;
  duration_median_s: Estimate;
  clearance_min_m: number | null;
  clearance_median_m: Estimate;
  speed_mean_median_m_s: Estimate;
  replans_median: Estimate;
  state_checks_median: Estimate;
  planning_time_us_median: Estimate;
  step_time_us_median: Estimate;
}

export interface PlannerPairing extends GroupKey {
  planner_a: string;
  planner_b: string;
  n: number;
  wins_a: number;
  ties: number;
  wins_b: number;
  win_share_a: Rate;
}

export interface World {
  world_id: string;
  bounds: [number, number, number, number];
  circles: [number, number, number][];
  polygons: number[][];
  segments: [number, number, number, number][];
  start: [number, number];
  goal: [number, number];
}

// Texts and integers of a record as strings, other numbers as numbers, NaN where absent.
export interface Trial {
  trial_id: string;
  suite: string;
  scenario: string;
  scenario_group: string;
  world_id: string;
  vehicle: string;
  regulator: string;
  planner: string;
  repetition: string;
  seed: string;
  outcome: string;
  reason: string;
  modes: string;
  duration_s: number;
  path_length_m: number;
  path_ratio: number;
  spl: number;
  clearance_min_m: number;
  speed_mean_m_s: number;
  end_x_m: number;
  end_y_m: number;
  planning_time_us_mean: number;
  step_time_us_mean: number;
  [column: string]: string | number;
}

type TextColumn = { texts: string[]; index: number[] };

interface Payload {
  title: string;
  manifest: unknown;
  outcomes: string[];
  summary: { groups: PlannerSummary[]; totals: PlannerSummary[]; pairings: PlannerPairing[] };
  trials: Record<string, TextColumn | (number | null)[]>;
  worlds: World[];
  traces: Record<string, string>;
  stored_traces: number;
}

export interface Report extends Omit<Payload, "trials" | "worlds"> {
  trials: Trial[];
  columns: string[];
  worlds: Map<string, World>;
  planners: string[];
  groups: string[];
  vehicles: string[];  // "vehicle" or "vehicle, regulator": what is compared with its like only
}

export const kGoal = "goal_reached";

export function vehicleOf(key: { vehicle: string; regulator: string }): string {
  return key.regulator ? `${key.vehicle}, ${key.regulator}` : key.vehicle;
}

// "forest-2" comes before "forest-10".
export function byName(a: string, b: string): number {
  return a.localeCompare(b, "en", { numeric: true });
}

function distinct(values: string[]): string[] {
  return [...new Set(values)].sort(byName);
}

function readTrials(columns: Payload["trials"]): Trial[] {
  const names = Object.keys(columns);
  const ids = columns.trial_id as TextColumn;
  return ids.index.map((_, i) => {
    const trial: Record<string, string | number> = {};
    for (const name of names) {
      const column = columns[name];
      trial[name] = Array.isArray(column) ? (column[i] ?? NaN) : column.texts[column.index[i]];
    }
    return trial as Trial;
  });
}

export function readReport(json: string): Report {
  const payload = JSON.parse(json) as Payload;
  const trials = readTrials(payload.trials);
  return {
    ...payload,
    trials,
    columns: Object.keys(payload.trials),
    worlds: new Map(payload.worlds.map((w) => [w.world_id, w])),
    planners: distinct(trials.map((t) => t.planner)),
    groups: distinct(trials.map((t) => t.scenario_group)),
    vehicles: distinct(trials.map(vehicleOf)),
  };
}

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
  known: Float64Array;
  range_m: Float64Array[];
}

export interface Trace {
  trial_id: string;
  body_radius_m: number;
  clearance_min_m: number;
  field_of_view_rad: number;
  max_range_m: number;
  modes: string[];
  plans: Float64Array[];  // x, y, x, y ...
  known_points: Float64Array;
  cluster_of: number[];
  hulls: Float64Array[];
  frames: Frames;
}

function undelta(column: (number | null)[], scale: number): Float64Array {
  const out = new Float64Array(column.length);
  let sum = 0;
  column.forEach((delta, i) => {
    sum += delta ?? 0;
    out[i] = delta === null ? NaN : sum / scale;
  });
  return out;
}

function points(flat: number[]): Float64Array {
  const out = new Float64Array(flat.length);
  for (let i = 0; i < flat.length; ++i) {
    out[i] = flat[i] / 1000 + (i >= 2 ? out[i - 2] : 0);
  }
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
  const f = raw.frames;
  const vx = undelta(f.vx_mm_s, 1000);
  const vy = undelta(f.vy_mm_s, 1000);
  return {
    trial_id: raw.trial_id,
    body_radius_m: raw.body_radius_m,
    clearance_min_m: raw.clearance_min_m,
    field_of_view_rad: raw.field_of_view_rad,
    max_range_m: raw.max_range_m,
    modes: raw.modes,
    plans: raw.plans.map(points),
    known_points: points(raw.known_points),
    cluster_of: raw.cluster_of,
    hulls: raw.hulls.map(points),
    frames: {
      count: f.t_ms.length,
      t_s: undelta(f.t_ms, 1000),
      x_m: undelta(f.x_mm, 1000),
      y_m: undelta(f.y_mm, 1000),
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

// Trials that can be drawn into one picture: one vehicle in one true world.
export interface Scene {
  key: string;
  scenario: string;
  scenario_group: string;
  vehicle: string;
  world: World;
  trials: Trial[];  // with a trace, ordered by repetition, then planner
}

export function scenesOf(report: Report): Scene[] {
  const scenes = new Map<string, Scene>();
  for (const trial of report.trials) {
    const world = report.worlds.get(trial.world_id);
    if (!world || !hasTrace(report, trial.trial_id)) continue;
    const vehicle = vehicleOf(trial);
    const key = JSON.stringify([trial.scenario, vehicle, trial.world_id]);
    let scene = scenes.get(key);
    if (!scene) {
      scene = {
        key, scenario: trial.scenario, scenario_group: trial.scenario_group, vehicle, world,
        trials: [],
      };
      scenes.set(key, scene);
    }
    scene.trials.push(trial);
  }
  const list = [...scenes.values()];
  for (const scene of list) {
    scene.trials.sort((a, b) => Number(a.repetition) - Number(b.repetition) ||
      byName(a.planner, b.planner));
  }
  return list.sort((a, b) => byName(a.scenario_group, b.scenario_group) ||
    byName(a.scenario, b.scenario) || byName(a.vehicle, b.vehicle) ||
    Number(a.trials[0].repetition) - Number(b.trials[0].repetition));
}

// One trial per planner: its first in this scene.
export function firstPerPlanner(scene: Scene): Trial[] {
  const seen = new Set<string>();
  return scene.trials.filter((t) => !seen.has(t.planner) && seen.add(t.planner))
    .sort((a, b) => byName(a.planner, b.planner));
}
