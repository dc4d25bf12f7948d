#pragma once

#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Places around p from which every part of the free space within `within_m` of p can be told: at
// least one lies in each connected part of {x in area : |x - p| <= within_m, no point closer than
// clearance_m}, namely where that part is closest to p. Sorted by distance from p. Such a place is
// p itself, or lies on the circle of clearance_m about a point (straight beyond p, where two
// circles cross, or where one meets the border of the area), pushed outwards by margin_m. Only
// places that are free are returned. O(n^2 m) for n points that near and m tests of n each: for the
// neighbourhood of a goal, not for a map.
std::vector<Vec2> closest_free_places(std::span<const Vec2> points, const Bounds& area,
                                      const Vec2& p, double within_m, double clearance_m,
                                      double margin_m);

}  // namespace voronaut
