#include <cmath>
#include <stdexcept>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/planners/navigation/shortcut.h"

// The stages of the loop that fly() calls.
namespace voronaut {

namespace {

// The papers' vehicle rises before it sets off: it has its height when it is this close and this
// slow.
constexpr double kHeightReached_m = 0.05;
constexpr double kHeightReached_m_s = 0.1;

ProblemConfig problem_config(const TrialSpec& spec) {
  return {spec.scenario.world->bounds(), spec.scenario.goal_world, spec.scenario.goal_tolerance_m,
          spec.vehicle.clearance_min_m};
}

const PlannerEntry& planner_entry(const TrialSpec& spec, const PlannerCatalog& planners) {
  const PlannerEntry* entry = planners.find(spec.planner.name);
  if (entry == nullptr) throw std::invalid_argument("unknown planner '" + spec.planner.name + "'");
  return *entry;
}

ompl::base::PlannerPtr make_planner(const TrialSpec& spec, const PlannerEntry& entry,
                                    const PlanningProblem& problem) {
  ompl::base::PlannerPtr planner = entry.make(problem.space_information());
  set_parameters(*planner, spec.planner.params);
  return planner;
}

Braking braking_of(const TrialSpec& spec) {
  const StoppingLaw law = stopping_law(spec.regulator, spec.vehicle);
  return {law.k_1_s, law.a_m_s2, spec.vehicle.clearance_min_m};
}

std::size_t ticks_per_scan_of(const TrialSpec& spec) {
  const double ticks = 1 / (spec.range_finder.rate_hz * spec.loop.vehicle_period_s);
  return static_cast<std::size_t>(std::max(1.0, std::round(ticks)));
}

int index_of(std::vector<std::string>& names, const std::string& name) {
  if (name.empty()) return -1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

}  // namespace

Flight::Flight(const TrialSpec& trial, const PlannerCatalog& planners, bool keep)
    : spec(trial),
      keep_scans(keep),
      ticks_per_scan(ticks_per_scan_of(trial)),
      model(make_model(trial.vehicle.model)),
      regulator(make_regulator(trial.regulator, trial.vehicle)),
      range_finder(trial.range_finder),
      sensor_noise(derive_seed(trial.planner_seed, {"range finder"}, 0)),
      map(trial.mapping),
      problem(problem_config(trial)),
      planner_traits(planner_entry(trial, planners).traits),
      planner(make_planner(trial, planner_entry(trial, planners), problem)),
      replan_policy(trial.navigation, planner_traits),
      tracker(trial.navigation, SpeedProfile{}, trial.vehicle.limits.max_speed_m_s),
      gaze(trial.navigation.gaze, trial.scenario.start_heading),
      braking(braking_of(trial)),
      referee(trial.scenario, trial.vehicle.body_radius_m, trial.shortest_length_m, trial.loop) {}

void Flight::sense(const VehicleState& state, double now_s) {
  const Pose2 pose{state.p_world.head<2>(), state.heading_world()};
  range_finder.sense(*spec.scenario.world, pose, now_s, sensor_noise, scan);
  log.scans.emplace_back().tick = log.ticks.size() - 1;
}

void Flight::update_map() {
  map.update(scan);
  belief = {map.snapshot(), &scan, map.scan_clusters(), scan.sensor_world};
}

void Flight::plan(const VehicleState& state, double now_s) {
  if (!departed) {
    const double error_m = state.p_world.z() - spec.scenario.cruise_height_m;
    departed =
        std::abs(error_m) < kHeightReached_m && std::abs(state.v_world.z()) < kHeightReached_m_s;
    if (!departed) return;
    log.departure_s = now_s;
  }
  const Vec2& p = belief.pose_world.p_world;
  problem.update(belief, p);
  tracker.advance(p);
  ScanEvent& event = log.scans.back();
  event.replan = replan_policy.reason(tracker, problem.geometry(), p, now_s);
  if (event.replan == ReplanReason::none) return;

  Plan plan = ask_for_plan(*planner, planner_traits, problem, spec.budget);
  ++log.replans;
  if (!problem.budget_stop().empty()) ++log.budget_stops;
  event.mode = index_of(log.modes, plan.mode);
  if (plan.status == PlanStatus::infeasible || plan.status == PlanStatus::refused) {
    referee.accept_infeasible(now_s, plan.status == PlanStatus::infeasible
                                         ? "the planner proved that no path exists"
                                         : "the planner refused the problem");
  }
  if (plan.path.empty()) {
    tracker.drop();
    return;
  }
  if (spec.navigation.shortcut && !planner_traits.plans_on_every_scan) {
    plan.path = shortcut(plan.path, problem.geometry());
  }
  if (keep_scans) log.plans.push_back(plan.path);
  tracker.follow(std::move(plan.path), plan.status == PlanStatus::to_goal);
}

Setpoint Flight::navigate(const VehicleState& state) {
  const Vec2 p = state.p_world.head<2>();
  Setpoint setpoint;
  setpoint.p_target_world = Vec3(p.x(), p.y(), spec.scenario.cruise_height_m);
  setpoint.heading_world = gaze.heading(tracker, p);
  if (!tracker.has_path()) return setpoint;

  tracker.advance(p);
  const double speed_m_s = state.v_world.head<2>().norm();
  const Aim aim = tracker.aim(p, speed_m_s, belief.obstacles, spec.vehicle.clearance_min_m);
  setpoint.p_target_world.head<2>() = aim.p_target_world;
  setpoint.brake_at_target = aim.at_goal;
  const Vec2 way = aim.p_target_world - p;
  const Vec2 towards = way.norm() > 0 ? Vec2(way.normalized()) : setpoint.heading_world;
  setpoint.speed_limit_m_s = speed_limit_m_s(spec.navigation.speed_rule, belief, towards, braking,
                                             spec.navigation.reaction_time_s, aim.speed_limit_m_s);
  return setpoint;
}

void Flight::record_scan(const Setpoint& setpoint) {
  ScanEvent& event = log.scans.back();
  event.setpoint = setpoint;
  if (event.mode < 0 && log.scans.size() > 1 && event.replan == ReplanReason::none) {
    event.mode = log.scans[log.scans.size() - 2].mode;
  }
  event.plan = tracker.has_path() ? static_cast<int>(log.plans.size()) - 1 : -1;
  event.known_points = belief.obstacles.points().size();
  event.planning_time_us = log.planning.samples_us().back();
  if (keep_scans) event.range_m.assign(scan.range_m.begin(), scan.range_m.end());
}

}  // namespace voronaut
