#include "voronaut/environments/world.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace voronaut {
namespace {

Bounds checked(const Bounds& bounds) {
  const Vec2 size_m = bounds.max - bounds.min;
  if (!std::isfinite(size_m.x()) || !std::isfinite(size_m.y())) {
    throw std::invalid_argument("bounds are not finite");
  }
  if (size_m.x() <= 0 || size_m.y() <= 0) throw std::invalid_argument("bounds have no area");
  if (size_m.maxCoeff() > kWidestBounds_m)
    throw std::invalid_argument("bounds are wider than 20 km");
  return bounds;
}

}  // namespace

World::World(const Bounds& bounds, Shapes shapes)
    : bounds_(checked(bounds)), shapes_(validated(std::move(shapes))), index_(shapes_) {}

}  // namespace voronaut
