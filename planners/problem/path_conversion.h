#pragma once

#include <ompl/geometric/PathGeometric.h>

#include "voronaut/dynamics/path.h"

namespace voronaut {

// The planar positions of a solution as straight pieces (yaw, where the space has one, is dropped).
// `space` is the problem's: a path of CForest belongs to a wrapper around it.
// Empty for a path of fewer than two distinct positions.
Path to_path(const ompl::geometric::PathGeometric& path, const ompl::base::StateSpace& space);
Path to_path(const ompl::geometric::PathGeometric& path);  // in the path's own space

}  // namespace voronaut
