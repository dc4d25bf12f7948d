#pragma once

#include <string>

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

// Adds the planners of a shared library (planners/catalog/plugin.h) to the catalogue. The library
// stays loaded; it is loaded in a child process first. Throws std::invalid_argument, naming the
// file, if it cannot be loaded, aborts or hangs meanwhile, is no plugin, was built for another
// version or fails to add its planners.
void load_plugin(const std::string& file, PlannerCatalog& planners);

}  // namespace voronaut
