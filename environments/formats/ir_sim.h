#pragma once

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A world of IR-SIM (hanruihua/ir-sim), YAML. Read: `world` (width, height, offset), of the first
// robot with a state and a goal these two, of each obstacle its shape (circle, rectangle, polygon,
// linestring) at its state, or the states of a number of them placed by hand. Without a size the
// world has IR-SIM's 10 m x 10 m. What is `unobstructed` is left out: nothing collides with it and
// no beam ends at it. What IR-SIM would draw at random, an `obstacle_map` and keys that IR-SIM does
// not have are errors; what it has besides (kinematics, behaviours, sensors, plots, other robots,
// obstacles' velocities) is not read. Throws ConfigError.
ForeignWorld read_ir_sim(const ConfigNode& root);

}  // namespace voronaut
