#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/config/config_node.h"

namespace voronaut {

// What `check` and `show` are asked about: a file, or the name of something that `voronaut list`
// has and that has worlds. Where a suite and a family or a data set share a name, `suites_first`
// decides.
struct NamedScenarios {
  ConfigNode root;  // of a suite file, or a scenario as read_scenarios() takes it
  bool is_suite = false;
};

// Throws ConfigError for a file that cannot be read, std::invalid_argument for a name of nothing,
// or of what has no worlds.
NamedScenarios find_scenarios(const std::string& argument, bool suites_first,
                              const std::vector<std::string>& planners);

// Whether the root of a file is that of a suite.
bool is_suite(const ConfigNode& root);

}  // namespace voronaut
