#pragma once

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A world of IR-SIM (hanruihua/ir-sim), YAML. Read: `world` (width, height, offset), of the first
// robot with a state and a goal these two, of each obstacle its shape (circle, rectangle, polygon,
// linestring) at its state, or the states of a number of them placed by hand. Obstacles that IR-SIM
// would draw at random are an error: there is no world to read. Everything else (kinematics,
// behaviours, sensors, plots, other robots, obstacles' velocities, `unobstructed`) is not read.
// Throws ConfigError.
ForeignWorld read_ir_sim(const ConfigNode& root);

}  // namespace voronaut
