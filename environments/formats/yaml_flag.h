#pragma once

#include "voronaut/environments/config/config_node.h"

namespace voronaut {

// A flag of a file that another program's YAML reader takes for one: true and false as in our own
// files, but also True, TRUE, yes, on and their opposites (YAML 1.1). Throws ConfigError.
bool read_yaml_flag(const ConfigNode& node);

}  // namespace voronaut
