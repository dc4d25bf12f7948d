#include "voronaut/planners/mapping/convex_polygon.h"

#include <algorithm>
#include <cstddef>

#include "voronaut/planners/mapping/orientation.h"

namespace voronaut {
namespace {

bool lexicographically_less(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// True if all of b lies strictly to the right of some edge of a.
bool edge_separates(std::span<const Vec2> a, std::span<const Vec2> b) {
  if (a.size() < 2) return false;
  const Vec2* from = &a.back();
  for (const Vec2& to : a) {
    const auto outside = [&](const Vec2& p) { return orientation(*from, to, p) < 0; };
    if (std::all_of(b.begin(), b.end(), outside)) return true;
    from = &to;
  }
  return false;
}

}  // namespace

void reduce_to_convex_hull(std::vector<Vec2>& points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return;
  // Monotone chain: the lower chain to the right, then the upper one back.
  std::vector<Vec2> hull;
  hull.reserve(points.size() + 1);
  const auto append = [&hull](const Vec2& p, std::size_t chain_begin) {
    while (hull.size() > chain_begin + 1 &&
           orientation(hull[hull.size() - 2], hull.back(), p) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2& p : points) append(p, 0);
  const std::size_t upper_begin = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) append(points[i], upper_begin);
  hull.pop_back();
  points = std::move(hull);
}

// The edges that see p from outside, or that p prolongs, are next to each other: p replaces the
// vertices between them.
bool add_to_convex_hull(std::vector<Vec2>& hull, const Vec2& p) {
  const std::size_t n = hull.size();
  if (n < 3) {
    const std::vector<Vec2> before = hull;
    hull.push_back(p);
    reduce_to_convex_hull(hull);
    return hull != before;
  }
  const auto turn_at_edge = [&](std::size_t i) {
    return orientation(hull[i], hull[i + 1 == n ? 0 : i + 1], p);
  };
  std::size_t seen = 0;
  while (seen < n && turn_at_edge(seen) >= 0) ++seen;
  if (seen == n) return false;
  std::size_t first = seen;  // first edge of the chain
  while (turn_at_edge(first == 0 ? n - 1 : first - 1) <= 0) first = first == 0 ? n - 1 : first - 1;
  std::size_t last = seen;
  while (turn_at_edge(last + 1 == n ? 0 : last + 1) <= 0) last = last + 1 == n ? 0 : last + 1;
  // Vertices first + 1 .. last fall, counted around the polygon.
  const std::size_t begin = first + 1 == n ? 0 : first + 1;
  const std::size_t falling = (last + n - first) % n;
  if (begin + falling <= n) {
    const auto at = hull.begin() + static_cast<std::ptrdiff_t>(begin);
    if (falling == 0) {
      hull.insert(at, p);
    } else {
      *at = p;
      hull.erase(at + 1, at + static_cast<std::ptrdiff_t>(falling));
    }
  } else {
    hull.resize(begin);
    hull.erase(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(begin + falling - n));
    hull.push_back(p);
  }
  const auto smallest = std::min_element(hull.begin(), hull.end(), lexicographically_less);
  std::rotate(hull.begin(), smallest, hull.end());
  return true;
}

Bounds bounding_box(std::span<const Vec2> points) {
  Bounds box{points.front(), points.front()};
  for (const Vec2& p : points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

bool convex_polygons_touch(std::span<const Vec2> a, std::span<const Vec2> b) {
  return boxes_touch(bounding_box(a), bounding_box(b)) && convex_polygons_touch_in_boxes(a, b);
}

// Two disjoint convex polygons are separated strictly by the line of an edge of one of them (the
// edges of their Minkowski difference are parallel to these). The exception, two segments or points
// on one line, is told by their boxes.
bool convex_polygons_touch_in_boxes(std::span<const Vec2> a, std::span<const Vec2> b) {
  return !edge_separates(a, b) && !edge_separates(b, a);
}

}  // namespace voronaut
