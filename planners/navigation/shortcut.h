#pragma once

#include "voronaut/dynamics/path.h"
#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

// The path without the corners it does not need: from each kept corner straight on to the farthest
// later one with a clear motion to it. Deterministic, never longer, every leg exactly clear. The
// same for every planner that plans whole paths; what OMPL's users get from simplifySolution().
// O(corners^2) motion checks at worst.
Path shortcut(const Path& path, const KnownGeometry& geometry);

}  // namespace voronaut
