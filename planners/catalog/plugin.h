#pragma once

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

// Grows when a library that was built for an older program would no longer fit.
inline constexpr int kPluginVersion = 1;

}  // namespace voronaut

// Planners in a shared library, for `voronaut run --plugin libmine.so`. Once in one source of it:
//
//   VORONAUT_PLUGIN(planners) {
//     planners.add({"Mine", "what it does", {}, [](const auto& si) { return ...; }});
//   }
//
// Compile it against the same OMPL and with the same compiler as the program. It need not link
// anything of Voronaut: the program's own symbols are there when it is loaded.
// NOLINTBEGIN(bugprone-macro-parentheses): a parameter's name cannot stand in parentheses
#define VORONAUT_PLUGIN(planners)                                                   \
  extern "C" __attribute__((visibility("default"))) int voronaut_plugin_version() { \
    return ::voronaut::kPluginVersion;                                              \
  }                                                                                 \
  extern "C" __attribute__((visibility("default"))) void voronaut_add_planners(     \
      ::voronaut::PlannerCatalog& planners)
// NOLINTEND(bugprone-macro-parentheses)
