#pragma once

#include <string>

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

// Adds the planners of a shared library (planners/catalog/plugin.h) to the catalogue. The library
// stays loaded. Throws std::invalid_argument, naming the file, if it cannot be loaded, is no
// plugin, was built for another version or fails to add its planners.
void load_plugin(const std::string& file, PlannerCatalog& planners);

}  // namespace voronaut
