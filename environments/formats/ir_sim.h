#pragma once

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A world of IR-SIM (hanruihua/ir-sim), YAML, at the root or under the key `irsim`. Read: `world`
// (width, height, offset), of the first robot its state with its heading and its goal (the first of
// several), of each obstacle its shape (circle, rectangle, polygon, linestring, compound) at its
// state, or at those of a number of them, of which the last repeats. What is not given is IR-SIM's:
// a world of 10 m x 10 m, the state [1, 1, 0], the goal [1, 9, 0], a circle of 0.2 m, a rectangle
// of 1 m x 1 m; empty `robot:` and `obstacle:` are none. What is `unobstructed` is left out:
// nothing collides with it and no beam ends at it. What IR-SIM would draw at random, an
// `obstacle_map` and keys that look misspelt are errors; what it has besides (kinematics,
// behaviours, sensors, plots, other robots, obstacles' velocities, fog) is not read. Throws
// ConfigError.
ForeignWorld read_ir_sim(const ConfigNode& root);

}  // namespace voronaut
