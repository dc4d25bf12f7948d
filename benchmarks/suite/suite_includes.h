#pragma once

#include "voronaut/environments/config/config_node.h"

namespace voronaut {

// A suite file with what it includes: `include: base.yaml` or `include: [a.yaml, b.yaml]`, beside
// the file that says so, which may include others. What a file says itself wins over what it
// includes, a later file of the list over an earlier one: maps key by key, lists as a whole.
// Throws ConfigError, also for files that include each other.
ConfigNode with_includes(const ConfigNode& root);

}  // namespace voronaut
