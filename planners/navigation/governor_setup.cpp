#include "voronaut/planners/navigation/governor_setup.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace voronaut {

namespace {

// What a body within the bounds may touch.
Bounds reachable_bounds(const NavigatorConfig& config) {
  const Bounds& bounds = config.mission.bounds_world;
  const double reach_m =
      std::max(config.vehicle.planning_clearance_m, config.vehicle.body_radius_m);
  return grown(bounds, reach_m);
}

// How far a vehicle's course swings from its path towards a wall, at a corner or braking, in the
// worst of the flights by which this was chosen.
constexpr double kSwingAside_m = 0.025;
constexpr double kFinestPart_m = 0.0125;
// Of cells that have parts.
constexpr double kLargestCell_m = 0.1;

// What is on a wall is never known free. So a tube keeps the diagonal of a part of a cell from it,
// and what planners keep beside the body must have room for that, for what a stop strays, and for
// the swing.
double part_m(const NavigatorConfig& config, const SafetyGovernor& governor) {
  const VehicleFacts& vehicle = config.vehicle;
  const double radius_m =
      vehicle.planned_smaller() ? vehicle.footprint.planned_radius_m : vehicle.body_radius_m;
  const double beside_body_m = vehicle.planning_clearance_m - radius_m;
  const double stray_m = governor.room_to_bounds_m(VehicleState{});
  const double diagonal_m = beside_body_m - stray_m - kSwingAside_m;
  return std::max(diagonal_m / std::numbers::sqrt2, kFinestPart_m);
}

FreeSpaceConfig cells_of(const NavigatorConfig& config) {
  FreeSpaceConfig cells;
  const auto governor = governor_of(config);
  if (!governor) return cells;
  const double finest_m = part_m(config, *governor);
  if (finest_m >= cells.cell_m) return cells;
  while (2 * cells.splits <= FreeSpace::kSplitsMax && 2 * cells.splits * finest_m <= kLargestCell_m)
    cells.splits *= 2;
  cells.cell_m = cells.splits * finest_m;
  return cells;
}

}  // namespace

std::optional<SafetyGovernor> governor_of(const NavigatorConfig& config) {
  if (!config.navigation.governor) return std::nullopt;
  const VehicleFacts& vehicle = config.vehicle;
  if (!vehicle.motion_response)
    throw std::invalid_argument(
        "a governor needs the vehicle's motion response (else navigation.governor = false)");
  const bool answers_arcs = !std::holds_alternative<VelocityResponse>(*vehicle.motion_response);
  if (answers_arcs != (vehicle.steering == Steering::along_heading))
    throw std::invalid_argument(
        "a governor needs a motion response of the kind of the vehicle's steering");
  return SafetyGovernor(*vehicle.motion_response, vehicle.body_radius_m,
                        vehicle.planning_clearance_m, config.range_finder.period_s,
                        config.mission.bounds_world, vehicle.footprint, config.errors);
}

FreeSpace free_space_of(const NavigatorConfig& config) {
  return FreeSpace(reachable_bounds(config), cells_of(config));
}

}  // namespace voronaut
