#pragma once

#include <functional>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// The border of the valid states as points, for a planner that has nothing but a validity check.
struct BoundarySamples {
  std::vector<Vec2> points;  // on invalid ground, next to the border
  // A disc of this radius cannot slip between neighbouring points of one border. What is thinner
  // than a cell between two grid points is not seen at all.
  double clearance_m = 0;
  bool complete = false;  // false: stopped before all of it was seen
};

// Asks for validity at the nodes of a grid of square cells, `cells` along the longer side of the
// area, and halves each grid edge whose ends differ down to 1/64 of a cell. O(cells^2) checks.
BoundarySamples sample_boundary(const std::function<bool(const Vec2&)>& is_valid,
                                const Bounds& area, int cells, const std::function<bool()>& stop);

}  // namespace voronaut
