#pragma once

#include <span>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/environments/shapes/shape_index.h"

// Exact ranges along rays: the smallest t in [0, max_range_m] at which origin + t * direction lies
// on or in a shape, max_range_m if there is none. Shapes are closed, so a ray that only touches one
// hits it, and a wall seen edge-on is hit at its nearer end. A ray that starts in or on a shape has
// range 0, which Scan reads as no measurement. Exact up to rounding: hits that a change of the
// ray by a few parts in 1e16 would remove may be missed or found.
namespace voronaut {

// One ray, by a walk through the cells. `direction` is a unit vector. O(cells passed).
double cast_ray(const ShapeIndex& shapes, const Vec2& origin, const Vec2& direction,
                double max_range_m);

// All beams of a fan at once: every primitive within reach updates the beams that it covers, found
// by cross products, without an angle. range_m has one entry per beam. Allocates nothing.
// O(beams + primitives in reach + beams they cover), whatever the number of shapes.
void cast_fan(const ShapeIndex& shapes, const Pose2& sensor, const BeamFan& fan, double max_range_m,
              std::span<double> range_m);

}  // namespace voronaut
