#pragma once

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

#include "voronaut/environments/shapes/geometry.h"

// Positions in the plane, read from and written to OMPL states. Two kinds of space have one:
// RealVectorStateSpace of two dimensions, and SE2StateSpace, whose yaw is left alone.
namespace voronaut {

bool has_position(const ompl::base::StateSpace& space);

// Both abort if the space has no position.
Vec2 position_of(const ompl::base::StateSpace& space, const ompl::base::State* state);
void set_position(const ompl::base::StateSpace& space, ompl::base::State* state, const Vec2& p);

// Bounds of the position, and a position brought back into them.
Bounds position_bounds(const ompl::base::StateSpace& space);
Vec2 clamped(const Vec2& p, const Bounds& bounds);

}  // namespace voronaut
