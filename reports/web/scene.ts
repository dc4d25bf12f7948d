import { byName, Report, Trial, vehicleOf, World } from "./data";
import { hasTrace } from "./trace";

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
