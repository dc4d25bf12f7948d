#pragma once

#include <span>

#include "voronaut/environments/shapes/shape_index.h"

// Exact distances from convex polygons: corners of a strictly convex polygon, counter-clockwise,
// metres, world frame W. The polygon is closed and solid, as all shapes are.
namespace voronaut {

// 0 if they have a point in common. O(corners).
double distance(std::span<const Vec2> convex, const Vec2& p);
double distance(std::span<const Vec2> convex, const Segment& s);
double distance(std::span<const Vec2> convex, const Circle& circle);

// min(within_m, distance from the polygon to the nearest shape), 0 where they touch. O(corners x
// primitives in reach).
double clearance_m(const ShapeIndex& shapes, std::span<const Vec2> convex,
                   double within_m = kInfinity);

}  // namespace voronaut
