#pragma once

#include <cstdint>
#include <vector>

#include "voronaut/environments/shapes/shape_index.h"

namespace voronaut {

// Clearances at places along a way, each near the one before: exactly what ShapeIndex::clearance_m
// says, at the cost of the few shapes that can be the nearest one around there.
class ClearanceAlong {
 public:
  // The index must outlive it.
  explicit ClearanceAlong(const ShapeIndex& shapes) : shapes_(shapes) {}

  // O(shapes that are nearly the nearest); where the way has gone on some decimetres, or lies
  // within some of a shape, as clearance_m().
  double at(const Vec2& p);

 private:
  double look_around(const Vec2& p);

  const ShapeIndex& shapes_;
  Vec2 center_ = Vec2::Zero();
  double reach_sq_ = -1;  // up to there around the centre one of these is the nearest
  std::vector<std::uint32_t> circles_, edges_;
};

}  // namespace voronaut
