import { byName, byVehicle, Report, Trial, vehicleOf, World } from "./data";
import { hasTrace, Trace } from "./trace";

const kMargin_m = 1;

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
    byName(a.scenario, b.scenario) || byVehicle(a.trials[0], b.trials[0]) ||
    Number(a.trials[0].repetition) - Number(b.trials[0].repetition));
}

// What is worth showing: everything that is there, where the ways went, and a metre around it, but not
// the empty rest of the bounds.
export function extentOf(world: World, traces: Trace[]): World["bounds"] {
  const xs = [world.start[0], world.goal[0]];
  const ys = [world.start[1], world.goal[1]];
  const flat = (points: ArrayLike<number>): void => {
    for (let i = 0; i + 1 < points.length; i += 2) {
      xs.push(points[i]);
      ys.push(points[i + 1]);
    }
  };
  for (const [x, y, r] of world.circles) flat([x - r, y - r, x + r, y + r]);
  [...world.polygons, ...world.segments].forEach(flat);
  const around = kMargin_m;
  const low = (values: number[]): number => values.reduce((a, b) => Math.min(a, b)) - around;
  const high = (values: number[]): number => values.reduce((a, b) => Math.max(a, b)) + around;
  const bounds = world.bounds;
  const inside = [Math.max(bounds[0], low(xs)), Math.max(bounds[1], low(ys)),
    Math.min(bounds[2], high(xs)), Math.min(bounds[3], high(ys))];
  for (const { frames } of traces) {
    inside[0] = Math.min(inside[0], frames.x_m.reduce((a, b) => Math.min(a, b), Infinity) - around);
    inside[1] = Math.min(inside[1], frames.y_m.reduce((a, b) => Math.min(a, b), Infinity) - around);
    inside[2] = Math.max(inside[2], frames.x_m.reduce((a, b) => Math.max(a, b), -Infinity) + around);
    inside[3] = Math.max(inside[3], frames.y_m.reduce((a, b) => Math.max(a, b), -Infinity) + around);
  }
  return inside as World["bounds"];
}

// One trial per planner: its first in this scene.
export function firstPerPlanner(scene: Scene): Trial[] {
  const seen = new Set<string>();
  return scene.trials.filter((t) => !seen.has(t.planner) && seen.add(t.planner))
    .sort((a, b) => byName(a.planner, b.planner));
}
