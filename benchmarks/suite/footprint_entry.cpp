#include "voronaut/benchmarks/suite/footprint_entry.h"

#include <cmath>

#include "voronaut/benchmarks/suite/entry_keys.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/shapes/robot_body.h"

namespace voronaut {

namespace {

constexpr double kLargest_m = 10;

std::vector<Vec2> read_polygon(const ConfigNode& node) {
  std::vector<Vec2> corners;
  for (const ConfigNode& corner : node.items()) {
    const auto xy = corner.numbers(2, "[x, y]", -kLargest_m, kLargest_m);
    corners.emplace_back(xy[0], xy[1]);
  }
  if (const std::string problem = body_problem(corners); !problem.empty())
    throw node.error("the polygon " + problem +
                     " (allowed: the corners of a strictly convex polygon around [0, 0])");
  return corners;
}

void take_polygon(std::vector<Vec2> corners, VehicleSpec& vehicle) {
  vehicle.body_radius_m = circumscribed_radius_m(corners);
  vehicle.footprint.corners_body = std::move(corners);
}

// Without what rounding makes of a side that is meant to be at 0.2 m.
double in_micrometres(double length_m) { return std::round(length_m * 1e6) / 1e6; }

void require_one_of(const ConfigNode& node) {
  constexpr const char* kShapes[] = {"disc", "polygon", "of_scenario"};
  std::string first;
  for (const char* key : kShapes) {
    if (!node.find(key)) continue;
    if (!first.empty())
      throw node.child(key).error("cannot stand beside " + first +
                                  " (allowed: disc, or polygon, or of_scenario)");
    first = key;
  }
  if (first.empty()) throw node.error("says no body (allowed: disc, or polygon, or of_scenario)");
}

}  // namespace

void read_footprint(const ConfigNode& node, const ConfigNode& entry, VehicleEntry& vehicle) {
  FootprintKeys keys;
  read_into(node, keys);
  require_one_of(node);
  const auto params = entry.find("params");
  if (const auto radius = params ? params->find("body_radius_m") : std::nullopt)
    throw radius->error("cannot stand beside footprint (allowed: one of them)");
  VehicleSpec& spec = vehicle.vehicle;
  spec.footprint = {};
  if (keys.disc > 0) spec.body_radius_m = keys.disc;
  if (const auto polygon = node.find("polygon")) take_polygon(read_polygon(*polygon), spec);
  vehicle.footprint_of_scenario = keys.of_scenario;
  const auto planned = node.find("planned_radius_m");
  if (!planned) return;
  if (keys.disc > 0) throw planned->error("is for a polygon: a disc is planned as it is");
  const double least_m = keys.of_scenario ? 0 : in_micrometres(spec.inscribed_radius_m());
  if (keys.planned_radius_m < least_m)
    throw planned->error(
        "expected at least the radius of the largest disc about the origin within "
        "the polygon, " +
        number_text(least_m) + ", got " + number_text(keys.planned_radius_m));
  if (mobility_of(spec).moves_sideways)
    throw planned->error("is for what drives along its heading: vehicle " + in_quotes(spec.name) +
                         " may go sideways as well");
  spec.footprint.planned_radius_m = keys.planned_radius_m;
}

std::string clearance_problem(const VehicleSpec& vehicle) {
  if (vehicle.planning_clearance_m >= vehicle.planned_radius_m()) return "";
  const std::string clearance =
      "planning_clearance_m " + number_text(vehicle.planning_clearance_m) + " is less than ";
  if (vehicle.footprint.is_disc())
    return clearance + "body_radius_m " + number_text(vehicle.body_radius_m);
  if (vehicle.footprint.planned_radius_m > 0)
    return clearance + "planned_radius_m " + number_text(vehicle.footprint.planned_radius_m);
  return clearance + number_text(vehicle.body_radius_m) +
         ", the radius of the disc that holds its polygon (allowed: at least that, or a "
         "planned_radius_m that says that it is planned smaller)";
}

bool take_footprint(const Scenario& scenario, VehicleSpec& vehicle) {
  if (!scenario.robot) return false;
  const RobotBody& robot = *scenario.robot;
  if (robot.corners_body.empty()) {
    vehicle.body_radius_m = robot.radius_m;
    vehicle.footprint = {};
  } else {
    take_polygon(robot.corners_body, vehicle);
  }
  return true;
}

void require_footprints(const ConfigNode& root, const SuiteConfig& suite) {
  const std::vector<ConfigNode> entries = root.child("vehicles").items();
  for (std::size_t i = 0; i < suite.vehicles.size(); ++i) {
    if (!suite.vehicles[i].footprint_of_scenario) continue;
    const ConfigNode place = entries[i].child("footprint").child("of_scenario");
    for (const ScenarioSpec& scenario : suite.scenarios) {
      VehicleSpec vehicle = suite.vehicles[i].vehicle;
      Scenario told;
      told.robot = scenario.robot();
      if (!take_footprint(told, vehicle))
        throw place.error("scenario " + in_quotes(scenario.name()) + " tells of no robot's body");
      if (const std::string problem = clearance_problem(vehicle); !problem.empty())
        throw place.error("in scenario " + in_quotes(scenario.name()) + " its " + problem);
    }
  }
}

}  // namespace voronaut
