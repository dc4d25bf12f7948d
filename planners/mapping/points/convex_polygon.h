#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

// Convex polygons of any number of vertices >= 1: a point, a segment, or strictly convex,
// counter-clockwise. All answers are exact for the given coordinates.
namespace voronaut {

// Replaces `points` by the vertices of their convex hull, from the lexicographically smallest.
// O(n log n).
void reduce_to_convex_hull(std::vector<Vec2>& points);

// Adds one point to a hull of that form, in place. True if it became a vertex. O(n), less if it
// lies near `vertex`, an index into the hull or anything: that is set to where the point went.
bool add_to_convex_hull(std::vector<Vec2>& hull, const Vec2& p, std::size_t& vertex);

inline double distance_sq(const Vec2& a, const Vec2& b) {
  const double x = a.x() - b.x();
  const double y = a.y() - b.y();
  return x * x + y * y;
}

inline void grow_to_hold(Bounds& box, const Vec2& p) {
  box.min = {std::min(box.min.x(), p.x()), std::min(box.min.y(), p.y())};
  box.max = {std::max(box.max.x(), p.x()), std::max(box.max.y(), p.y())};
}

Bounds bounding_box(std::span<const Vec2> points);

// Both boxes are closed: a common edge or corner counts.
inline bool boxes_touch(const Bounds& a, const Bounds& b) {
  return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() && a.min.y() <= b.max.y() &&
         b.min.y() <= a.max.y();
}

// True if the two have at least one point in common, their boundaries included (what Boost.Geometry
// calls intersects). O(n m), by a separating edge. The second form expects that their boxes touch.
bool convex_polygons_touch(std::span<const Vec2> a, std::span<const Vec2> b);
bool convex_polygons_touch_in_boxes(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace voronaut
