#include "voronaut/benchmarks/trial/trial_id.h"

#include <variant>

#include "voronaut/benchmarks/trial/sha256.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/world.h"

namespace voronaut {

namespace {

std::string point_text(const Vec2& p) { return number_text(p.x()) + "," + number_text(p.y()); }

template <class Config>
std::string section(const std::string& name, const Config& config) {
  return name + ": " + canonical_text(config) + "\n";
}

template <class... Configs>
std::string section(const std::string& name, const std::variant<Configs...>& config) {
  return std::visit([&](const auto& chosen) { return section(name, chosen); }, config);
}

// Disturbances and what is declared of them name a trial only where there are any: those of suites
// without them keep their ids.
ConfigEntries flight_entries(const FlightConfig& flight) {
  ConfigEntries entries = config_entries(flight);
  const auto leave_out = [&](std::string_view name, const auto& now, const auto& by_default) {
    if (canonical_text(now) != canonical_text(by_default)) return;
    std::erase_if(entries, [&](const auto& entry) { return entry.first.starts_with(name); });
  };
  leave_out("disturbances.", flight.disturbances, DisturbanceConfig{});
  leave_out("declared_errors.", flight.declared_errors, DeclaredErrors{});
  return entries;
}

ConfigEntries task_entries(const TrialSpec& spec) {
  const Scenario& scenario = spec.scenario;
  ConfigEntries entries = {{"suite", spec.suite},
                           {"scenario", scenario.name},
                           {"group", scenario.group},
                           {"world_id", spec.world_id},
                           {"start_height_m", number_text(scenario.start_height_m)},
                           {"cruise_height_m", number_text(scenario.cruise_height_m)},
                           {"start_heading", point_text(scenario.start_heading)},
                           {"goal_tolerance_m", number_text(scenario.goal_tolerance_m)},
                           {"vehicle", spec.vehicle.name},
                           {"regulator", spec.regulator_name},
                           {"planner", spec.planner.label},
                           {"planner_name", spec.planner.name},
                           {"repetition", std::to_string(spec.repetition)},
                           {"planner_seed", std::to_string(spec.planner_seed)}};
  if (scenario.barn_length_m > 0)
    entries.emplace_back("barn_length_m", number_text(scenario.barn_length_m));
  if (spec.kind == TrialKind::static_planning) entries.emplace_back("kind", "static");
  return entries;
}

// Of a polygon; a disc is told by the vehicle's section.
std::string footprint_text(const Footprint& footprint) {
  if (footprint.is_disc()) return "";
  std::string text = "footprint:";
  for (const Vec2& corner : footprint.corners_body) text += " " + point_text(corner);
  return text + " planned " + number_text(footprint.planned_radius_m) + "\n";
}

}  // namespace

std::string canonical_world(const Scenario& scenario) {
  const World& world = *scenario.world;
  std::string text =
      "bounds " + point_text(world.bounds().min) + " " + point_text(world.bounds().max) + "\n";
  for (const Circle& circle : world.shapes().circles)
    text += "circle " + point_text(circle.center) + " " + number_text(circle.radius_m) + "\n";
  for (const Segment& wall : world.shapes().segments)
    text += "segment " + point_text(wall.a) + " " + point_text(wall.b) + "\n";
  for (const Polygon& polygon : world.shapes().polygons) {
    text += "polygon";
    for (const Vec2& vertex : polygon.vertices) text += " " + point_text(vertex);
    text += "\n";
  }
  return text + "start " + point_text(scenario.start_world) + "\ngoal " +
         point_text(scenario.goal_world) + "\n";
}

std::string world_id(const Scenario& scenario) { return sha256_hex(canonical_world(scenario)); }

std::string canonical_trial(const TrialSpec& spec) {
  ConfigEntries params(spec.planner.params.begin(), spec.planner.params.end());
  return "trial: " + canonical_text(task_entries(spec)) + "\n" +
         "params: " + canonical_text(params) + "\n" + section("vehicle", spec.vehicle) +
         footprint_text(spec.vehicle.footprint) + section("model", spec.vehicle.model) +
         section("regulator", spec.regulator) + section("flight", flight_entries(spec.flight));
}

std::string trial_id(const TrialSpec& spec) { return sha256_hex(canonical_trial(spec)); }

}  // namespace voronaut
