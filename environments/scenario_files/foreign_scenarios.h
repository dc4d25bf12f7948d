#pragma once

#include "voronaut/environments/scenario_files/scenario_fields.h"

// Scenarios in worlds that come from files of other projects. Both throw ConfigError.
namespace voronaut {

// An entry with `world_file`: one scenario from the file's own start and goal or the given ones, or
// one for each selected query of `queries`, called "<name>_<query>".
ScenarioSpecs read_world_file_entry(const ConfigNode& entry, const DataLocation& data);

// An entry with `dataset`: one scenario for each selected world.
ScenarioSpecs read_data_set_entry(const ConfigNode& entry, const DataLocation& data);

}  // namespace voronaut
