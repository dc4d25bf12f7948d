#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/suite/suite_config.h"

namespace voronaut {

// Why results of two suites must not be compared: "key: value, other value" for each setting in
// which they differ, key of a list's item by its name ("planners.RRTConnect.params.range"). Items
// of lists that one of them alone has, how often is repeated and what is kept do not count, nor do
// the keys that `across` names, or what lies below them.
std::vector<std::string> suite_differences(const SuiteConfig& before, const SuiteConfig& now,
                                           const std::vector<std::string>& across);

}  // namespace voronaut
