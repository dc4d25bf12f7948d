#include "voronaut/planners/problem/planar_state.h"

#include <cstdio>
#include <cstdlib>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>

namespace voronaut {

namespace ob = ompl::base;

namespace {

[[noreturn]] void refuse(const ob::StateSpace& space) {
  std::fprintf(stderr, "state space '%s' has no position in the plane\n", space.getName().c_str());
  std::abort();
}

}  // namespace

bool has_position(const ob::StateSpace& space) {
  return (space.getType() == ob::STATE_SPACE_REAL_VECTOR && space.getDimension() == 2) ||
         space.getType() == ob::STATE_SPACE_SE2;
}

Vec2 position_of(const ob::StateSpace& space, const ob::State* state) {
  if (space.getType() == ob::STATE_SPACE_SE2) {
    const auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    return {se2->getX(), se2->getY()};
  }
  if (!has_position(space)) refuse(space);
  const auto* real = state->as<ob::RealVectorStateSpace::StateType>();
  return {real->values[0], real->values[1]};
}

void set_position(const ob::StateSpace& space, ob::State* state, const Vec2& p) {
  if (space.getType() == ob::STATE_SPACE_SE2) {
    state->as<ob::SE2StateSpace::StateType>()->setXY(p.x(), p.y());
    return;
  }
  if (!has_position(space)) refuse(space);
  auto* real = state->as<ob::RealVectorStateSpace::StateType>();
  real->values[0] = p.x();
  real->values[1] = p.y();
}

Bounds position_bounds(const ob::StateSpace& space) {
  if (!has_position(space)) refuse(space);
  const ob::RealVectorBounds& bounds = space.getType() == ob::STATE_SPACE_SE2
                                           ? space.as<ob::SE2StateSpace>()->getBounds()
                                           : space.as<ob::RealVectorStateSpace>()->getBounds();
  return {{bounds.low[0], bounds.low[1]}, {bounds.high[0], bounds.high[1]}};
}

Vec2 clamped(const Vec2& p, const Bounds& bounds) {
  return p.cwiseMax(bounds.min).cwiseMin(bounds.max);
}

}  // namespace voronaut
