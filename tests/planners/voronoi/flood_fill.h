#pragma once

#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

namespace voronaut::voronoi_test {

enum class Connected { yes, no, too_close_to_call };

// Whether start and goal are connected at a clearance, by flooding a grid twice: with the clearance
// raised by what a cell can hide (then it is true), and lowered by it (then it is false).
Connected flood_fill(const PointWorld& world, double clearance_m);

}  // namespace voronaut::voronoi_test
