#pragma once

#include <optional>

#include "voronaut/dynamics/footprint.h"
#include "voronaut/dynamics/path.h"
#include "voronaut/planners/mapping/obstacle_snapshot.h"

namespace voronaut {

// Where along a path a polygon does not fit that was planned as a smaller disc: a place on the
// first segment along which, or the corner at which, the polygon would touch a known point as it
// drives along the path and turns at its corners; none: it fits. The turn to the path, from the
// heading that the body has, is not looked at. Arcs count as chords.
// Exact along segments; at corners to 2 mm of a body of 0.4 m. O(segments x known points).
std::optional<Vec2> first_misfit(const Footprint& footprint, const Path& path,
                                 const ObstacleSnapshot& known);

}  // namespace voronaut
