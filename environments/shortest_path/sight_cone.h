#pragma once

#include "voronaut/environments/shapes/shape_index.h"

namespace voronaut {

// A bundle of straight lines: their points at t along the unit vector `axis` from the apex lie
// within half_width_m + t * half_slope of it, from t = half_width_m on.
struct SightCone {
  Vec2 apex;
  Vec2 axis;
  double half_width_m = 0;
  double half_slope = 0;
};

// How far, along the axis, a disc of radius_m can get on any line of the cone: a bound from above,
// +infinity if no single shape within range_m is known to block them all. O(cells along the axis).
double sight_range_m(const ShapeIndex& shapes, const SightCone& cone, double radius_m,
                     double range_m);

}  // namespace voronaut
