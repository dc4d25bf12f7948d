#pragma once

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/foreign_world.h"

namespace voronaut {

// A DenseMap of PathBench (perfectly-balanced/PathBench: data/maps), JSON: `grid`, rows from the
// top of 0 (free), 1 (wall), 2 (agent), 3 (goal); `agent` and `goal` as [row, column], which become
// centres of cells. `type` must be DenseMap, of two dimensions; `version` is not
// read. Throws ConfigError.
ForeignWorld read_pathbench(const ConfigNode& root, double cell_size_m);

}  // namespace voronaut
