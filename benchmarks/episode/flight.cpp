#include "voronaut/benchmarks/episode/flight.h"

#include <cmath>

namespace voronaut {

namespace {

std::size_t ticks_per_scan_of(const TrialSpec& spec) {
  const double ticks = 1 / (spec.flight.range_finder.rate_hz * spec.flight.loop.vehicle_period_s);
  return static_cast<std::size_t>(std::max(1.0, std::round(ticks)));
}

VehicleFacts vehicle_facts(const TrialSpec& spec) {
  const double period_s = spec.flight.loop.vehicle_period_s;
  const StoppingLaw law = stopping_law(spec.regulator, spec.vehicle);
  VehicleFacts facts;
  facts.body_radius_m = spec.vehicle.body_radius_m;
  facts.footprint = spec.vehicle.footprint;
  facts.planning_clearance_m = spec.vehicle.planning_clearance_m;
  facts.steering =
      mobility_of(spec.vehicle).moves_sideways ? Steering::any_direction : Steering::along_heading;
  facts.limits = spec.vehicle.limits;
  facts.velocity_gain_1_s = law.k_1_s;
  facts.deceleration_m_s2 = law.a_m_s2;
  facts.goal_profile =
      std::visit([](const auto& regulator) { return regulator.profile; }, spec.regulator);
  if (spec.flight.navigation.governor)
    facts.motion_response = motion_response(spec.regulator, spec.vehicle, period_s);
  return facts;
}

Pose2 pose_of(const VehicleState& state) {
  return {state.p_world.head<2>(), state.heading_world()};
}

}  // namespace

NavigatorConfig navigator_config(const TrialSpec& spec) {
  const Scenario& scenario = spec.scenario;
  NavigatorConfig config;
  config.mission = {.start_world = scenario.start_world,
                    .start_heading = scenario.start_heading,
                    .goal_world = scenario.goal_world,
                    .goal_tolerance_m = scenario.goal_tolerance_m,
                    .cruise_height_m = scenario.cruise_height_m,
                    .bounds_world = scenario.world->bounds()};
  config.vehicle = vehicle_facts(spec);
  config.range_finder = {
      .field_of_view_rad = spec.flight.range_finder.field_of_view_rad,
      .period_s = static_cast<double>(ticks_per_scan_of(spec)) * spec.flight.loop.vehicle_period_s};
  config.planner = spec.planner.name;
  config.planner_params = spec.planner.params;
  config.budget = spec.flight.budget;
  config.mapping = spec.flight.mapping;
  config.navigation = spec.flight.navigation;
  config.errors = spec.flight.declared_errors;
  return config;
}

Flight::Flight(const TrialSpec& trial, const PlannerCatalog& planners, bool keep_scans)
    : spec(trial),
      ticks_per_scan(ticks_per_scan_of(trial)),
      model(make_model(trial.vehicle.model)),
      regulator(make_regulator(trial.regulator, trial.vehicle, trial.flight.loop.vehicle_period_s)),
      disturbances(trial.flight.disturbances, model->hold(), trial.flight.loop.vehicle_period_s,
                   derive_seed(trial.planner_seed, {"disturbances"}, 0)),
      estimate(
          trial.flight.declared_errors,
          [this](const VehicleState& state, const Command& command) {
            return model->step(state, command, spec.flight.loop.vehicle_period_s);
          },
          model->hold(), trial.flight.loop.vehicle_period_s),
      range_finder(trial.flight.range_finder),
      sensor_noise(derive_seed(trial.planner_seed, {"range finder"}, 0)),
      navigator(navigator_config(trial), planners),
      recorder(*trial.scenario.world, trial.vehicle, navigator, keep_scans),
      referee(trial.scenario, trial.vehicle, trial.shortest_length_m, trial.flight.loop,
              trial.contacts) {}

VehicleState Flight::at_start() const {
  const Scenario& scenario = spec.scenario;
  const Vec2& p = scenario.start_world;
  return model->at_rest(Vec3(p.x(), p.y(), scenario.start_height_m), scenario.start_heading);
}

const Scan& Flight::sense(const VehicleState& state, const VehicleState& believed, double now_s) {
  range_finder.sense(*spec.scenario.world, pose_of(state), now_s, sensor_noise, scan);
  scan.sensor_world = pose_of(believed);
  return scan;
}

}  // namespace voronaut
