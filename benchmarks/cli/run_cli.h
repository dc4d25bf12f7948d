#pragma once

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

// The program `voronaut` with these planners. A main() of three lines enters a planner of its own:
//
//   auto planners = voronaut::PlannerCatalog::built_in();
//   planners.add({"Mine", "what it does", {}, [](const auto& si) { return ...; }});
//   return voronaut::run_cli(argc, argv, planners);
//
// Returns the exit code: 0 success, 1 ran but something failed, 2 bad input (one line on stderr).
int run_cli(int argc, char** argv, const PlannerCatalog& planners);

}  // namespace voronaut
