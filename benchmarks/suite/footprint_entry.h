#pragma once

#include <string>

#include "voronaut/benchmarks/suite/suite_config.h"

// Bodies of vehicles as suites give them:
//
//   footprint: {disc: 0.2}
//   footprint: {polygon: [[0.23, 0.21], [-0.23, 0.21], [-0.23, -0.21], [0.23, -0.21]]}
//   footprint: {polygon: [...], planned_radius_m: 0.22}   planned as a smaller disc than holds it
//   footprint: {of_scenario: true}                        each scenario's file tells it
namespace voronaut {

// Reads `footprint` of a vehicle's entry into it. Throws ConfigError at the key: a polygon must be
// simple (Boost.Geometry's is_valid), strictly convex and hold the origin.
void read_footprint(const ConfigNode& node, const ConfigNode& entry, VehicleEntry& vehicle);

// Why planners would not keep the vehicle's body, or the disc that it says to be planned as, from
// obstacles; empty if they do.
std::string clearance_problem(const VehicleSpec& vehicle);

// Gives the vehicle the body of the scenario's robot. False, and nothing is done, if the scenario
// tells of none.
bool take_footprint(const Scenario& scenario, VehicleSpec& vehicle);

// For a suite that is complete: every scenario tells the bodies that vehicles take from it, and
// their clearances hold them. Throws ConfigError at the suite's `vehicles`.
void require_footprints(const ConfigNode& root, const SuiteConfig& suite);

}  // namespace voronaut
