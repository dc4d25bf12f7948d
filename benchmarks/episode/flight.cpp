#include <cmath>
#include <stdexcept>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/index_of.h"
#include "voronaut/planners/navigation/shortcut.h"

// The stages of the loop that fly() calls.
namespace voronaut {

namespace {

// The bounds are no wall: a path along them needs room for the vehicle to be beside it.
constexpr double kInsideBounds_m = 0.15;
// Out of a pocket in legs as long as this; after each the planner is asked again.
constexpr double kRetraceLeg_m = 0.5;

// The bounds within which paths are planned: start and goal lie within in any case.
Bounds planning_bounds(const Scenario& scenario) {
  const Bounds& world = scenario.world->bounds();
  const Vec2 inset(kInsideBounds_m, kInsideBounds_m);
  const Vec2 low = scenario.start_world.cwiseMin(scenario.goal_world);
  const Vec2 high = scenario.start_world.cwiseMax(scenario.goal_world);
  return {(world.min + inset).cwiseMin(low), (world.max - inset).cwiseMax(high)};
}

// What a body within the bounds may touch.
Bounds reachable_bounds(const TrialSpec& spec) {
  const Bounds& world = spec.scenario.world->bounds();
  const Vec2 rim(spec.vehicle.planning_clearance_m, spec.vehicle.planning_clearance_m);
  return {world.min - rim, world.max + rim};
}

ProblemConfig problem_config(const TrialSpec& spec) {
  return {planning_bounds(spec.scenario), spec.scenario.goal_world, spec.scenario.goal_tolerance_m,
          spec.vehicle.planning_clearance_m};
}

const PlannerEntry& planner_entry(const TrialSpec& spec, const PlannerCatalog& planners) {
  const PlannerEntry* entry = planners.find(spec.planner.name);
  if (entry == nullptr) throw std::invalid_argument("unknown planner '" + spec.planner.name + "'");
  return *entry;
}

ompl::base::PlannerPtr make_planner(const TrialSpec& spec, const PlannerEntry& entry,
                                    const PlanningProblem& problem) {
  ompl::base::PlannerPtr planner = entry.make(problem.space_information());
  set_parameters(*planner, spec.planner.name, spec.planner.params);
  return planner;
}

Braking braking_of(const TrialSpec& spec) {
  const StoppingLaw law = stopping_law(spec.regulator, spec.vehicle);
  return {law.k_1_s, law.a_m_s2, spec.vehicle.planning_clearance_m};
}

std::size_t ticks_per_scan_of(const TrialSpec& spec) {
  const double ticks = 1 / (spec.flight.range_finder.rate_hz * spec.flight.loop.vehicle_period_s);
  return static_cast<std::size_t>(std::max(1.0, std::round(ticks)));
}

std::optional<SafetyGovernor> governor_of(const TrialSpec& spec) {
  if (!spec.flight.navigation.governor) return std::nullopt;
  const double period_s = spec.flight.loop.vehicle_period_s;
  return SafetyGovernor(velocity_response(spec.regulator, spec.vehicle, period_s),
                        spec.vehicle.body_radius_m, spec.vehicle.planning_clearance_m,
                        static_cast<double>(ticks_per_scan_of(spec)) * period_s);
}

}  // namespace

Flight::Flight(const TrialSpec& trial, const PlannerCatalog& planners, bool keep)
    : spec(trial),
      keep_scans(keep),
      ticks_per_scan(ticks_per_scan_of(trial)),
      model(make_model(trial.vehicle.model)),
      regulator(make_regulator(trial.regulator, trial.vehicle)),
      range_finder(trial.flight.range_finder),
      sensor_noise(derive_seed(trial.planner_seed, {"range finder"}, 0)),
      map(trial.flight.mapping),
      free_space(reachable_bounds(trial)),
      problem(problem_config(trial)),
      planner_traits(planner_entry(trial, planners).traits),
      planner(make_planner(trial, planner_entry(trial, planners), problem)),
      replan_policy(trial.flight.navigation, planner_traits),
      tracker(trial.flight.navigation, SpeedProfile{}, trial.vehicle.limits.max_speed_m_s),
      gaze(trial.flight.navigation.gaze, trial.scenario.start_heading),
      look_around(trial.flight.range_finder.field_of_view_rad),
      recovery(trial.flight.navigation.stall_timeout_s),
      braking(braking_of(trial)),
      governor(governor_of(trial)),
      referee(trial.scenario, trial.vehicle.body_radius_m, trial.shortest_length_m,
              trial.flight.loop) {
  if (governor) free_space.mark_disc(trial.scenario.start_world, trial.vehicle.body_radius_m);
}

void Flight::sense(const VehicleState& state, double now_s) {
  const Pose2 pose{state.p_world.head<2>(), state.heading_world()};
  range_finder.sense(*spec.scenario.world, pose, now_s, sensor_noise, scan);
  log.scans.emplace_back().tick = log.ticks.size() - 1;
}

void Flight::update_map() {
  map.update(scan);
  if (governor) free_space.update(scan);
  belief = {virtual_obstacles.over(map.snapshot()), &scan, map.scan_clusters(), scan.sensor_world};
}

void Flight::plan(const VehicleState& state, double now_s) {
  if (!departed && !depart(state, now_s)) return;
  const Vec2& p = belief.pose_world.p_world;
  if (spec.flight.navigation.recovery) recover(state, now_s);
  problem.update(belief, p);
  tracker.advance(p);
  if (retracing) {
    way_flown.go_back(p);
    if (tracker.remaining_m() < WayFlown::kSpacing_m) tracker.drop();  // ask from here
  } else {
    way_flown.go_on(p);
  }
  ScanEvent& event = log.scans.back();
  event.replan = replan_policy.reason(tracker, problem.geometry(), p, now_s);
  if (event.replan == ReplanReason::none) return;

  Plan plan = ask_for_plan(*planner, planner_traits, problem, spec.flight.budget);
  ++log.replans;
  ++log.solve_ends[static_cast<std::size_t>(plan.end)];
  event.solve_end = plan.end;
  event.mode = index_of(log.modes, plan.mode);
  adopt(std::move(plan), now_s);
}

void Flight::adopt(Plan plan, double now_s) {
  const bool proof_holds = virtual_obstacles.empty();
  if (plan.status == PlanStatus::infeasible && proof_holds) {
    judge_infeasible(now_s);
    return;
  }
  referee.note_refusal(plan.refusal);
  if (plan.path.empty()) {
    if (!retracing) tracker.drop();
    return;
  }
  retracing = false;
  if (spec.flight.navigation.shortcut && !planner_traits.plans_on_every_scan) {
    plan.path = shortcut(plan.path, problem.geometry());
  }
  if (keep_scans) log.plans.push_back(plan.path);
  tracker.follow(std::move(plan.path), plan.status == PlanStatus::to_goal);
}

// That no path exists from here may be the vehicle's own doing: it stands in a pocket that it came
// into through a passage too narrow for planners. What counts is whether the mission has a path.
void Flight::judge_infeasible(double now_s) {
  tracker.drop();
  problem.update(belief, spec.scenario.start_world);
  const Plan from_start = ask_for_plan(*planner, planner_traits, problem, spec.flight.budget);
  problem.update(belief, belief.pose_world.p_world);
  if (from_start.status == PlanStatus::infeasible) {
    referee.accept_infeasible(now_s, problem.goal_has_place()
                                         ? "the planner proved that no path exists"
                                         : "no place at the goal keeps the clearance from what is "
                                           "known");
  } else if (spec.flight.navigation.recovery) {
    retrace();
  }
}

void Flight::retrace() {
  retracing = true;
  Path back = way_flown.back_from(belief.pose_world.p_world, kRetraceLeg_m);
  if (back.empty()) return;
  if (keep_scans) log.plans.push_back(back);
  tracker.follow(std::move(back), true);
}

void Flight::record_scan(const Setpoint& setpoint) {
  ScanEvent& event = log.scans.back();
  event.setpoint = setpoint;
  event.executive = executive;
  if (event.mode < 0 && log.scans.size() > 1 && event.replan == ReplanReason::none) {
    event.mode = log.scans[log.scans.size() - 2].mode;
  }
  event.plan = tracker.has_path() ? static_cast<int>(log.plans.size()) - 1 : -1;
  event.known_points = map.snapshot().points().size();
  event.planning_time_us = log.planning.samples_us().back();
  if (!keep_scans) return;
  event.range_m.assign(scan.range_m.begin(), scan.range_m.end());
  log.clusters.note(log.scans.size() - 1, map.snapshot());
  if (event.replan != ReplanReason::none && !planner_traits.plans_on_every_scan)
    log.searches.push_back(problem.searched_edges(*planner));
  event.search = static_cast<int>(log.searches.size()) - 1;
}

}  // namespace voronaut
