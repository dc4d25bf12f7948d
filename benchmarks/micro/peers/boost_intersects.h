#pragma once

#include <vector>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Boost.Geometry's intersects for hulls of one, two or more vertices; in a file of its own because
// it is slow to compile.
bool boost_intersects(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace voronaut
