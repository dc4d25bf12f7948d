#pragma once

#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "voronaut/dynamics/path.h"
#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// The planar positions of a path, in its order (yaw, where the space has one, is dropped).
std::vector<Vec2> positions_of(const ompl::geometric::PathGeometric& path,
                               const ompl::base::StateSpace& space);

// The planar positions of a solution as straight pieces.
// `space` is the problem's: a path of CForest belongs to a wrapper around it.
// Empty for a path of fewer than two distinct positions.
Path to_path(const ompl::geometric::PathGeometric& path, const ompl::base::StateSpace& space);
Path to_path(const ompl::geometric::PathGeometric& path);  // in the path's own space

}  // namespace voronaut
