#pragma once

#include "voronaut/environments/shapes/shape_index.h"
#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

// The widest bounds: maps and diagrams know places of a mission to a fraction of a millimetre.
inline constexpr double kWidestBounds_m = 20'000;

// The ground truth: obstacles within bounds. Never changes, so any number of trials may share one
// behind a shared_ptr. The bounds limit the centre of a vehicle: sensors do not see them, but one
// that leaves them has failed.
class World {
 public:
  // Throws std::invalid_argument on bounds that are not finite, have no area or are wider than
  // kWidestBounds_m, and as validated() does. Shapes may reach across the bounds. O(shapes).
  World(const Bounds& bounds, Shapes shapes);

  const Bounds& bounds() const { return bounds_; }
  const Shapes& shapes() const { return shapes_; }
  const ShapeIndex& index() const { return index_; }

  // Distance from p to the nearest shape, negative inside solids, +infinity in an empty world.
  double clearance_m(const Vec2& p) const { return index_.clearance_m(p); }
  // Whether a disc of radius_m > 0 can move from a to b; touching is allowed. Bounds not asked.
  bool segment_is_clear(const Vec2& a, const Vec2& b, double radius_m) const {
    return index_.segment_is_clear(a, b, radius_m);
  }

 private:
  Bounds bounds_;
  Shapes shapes_;
  ShapeIndex index_;
};

}  // namespace voronaut
