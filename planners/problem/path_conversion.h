#pragma once

#include <ompl/geometric/PathGeometric.h>

#include "voronaut/dynamics/path.h"

namespace voronaut {

// The planar positions of a solution as straight pieces (yaw, where the space has one, is dropped).
// Empty for a path of fewer than two distinct positions.
Path to_path(const ompl::geometric::PathGeometric& path);

}  // namespace voronaut
