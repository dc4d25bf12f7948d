#pragma once

#include <string>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Why a polygon of finite coordinates is not valid (OGC 06-103r4: simple, with an inside), as
// Boost.Geometry says it; empty if it is. Either orientation is valid. O(v log v).
std::string validity_problem(const Polygon& polygon);

}  // namespace voronaut
