#include "voronaut/planners/mapping/points/convex_polygon.h"

#include <algorithm>
#include <cstddef>

#include "voronaut/planners/mapping/points/orientation.h"
#include "voronaut/planners/mapping/points/packed_point.h"

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

namespace {

// Around a polygon of n vertices.
std::size_t next(std::size_t i, std::size_t n) { return i + 1 == n ? 0 : i + 1; }
std::size_t previous(std::size_t i, std::size_t n) { return (i == 0 ? n : i) - 1; }

void begin_with_smallest(std::vector<Vec2>& hull, std::size_t& vertex) {
  const auto smallest = std::min_element(hull.begin(), hull.end(), lexicographically_less);
  const auto before = static_cast<std::size_t>(smallest - hull.begin());
  vertex = vertex >= before ? vertex - before : vertex + hull.size() - before;
  std::rotate(hull.begin(), smallest, hull.end());
}

// A point, or two in order, or three collinear ones of which the middle one falls, or a triangle.
bool add_to_small_hull(std::vector<Vec2>& hull, const Vec2& p) {
  if (hull.size() == 2) {
    const double turn = orientation(hull[0], hull[1], p);
    if (turn == 0) {
      if (lexicographically_less(p, hull[0])) {
        hull[0] = p;
        return true;
      }
      if (!lexicographically_less(hull[1], p)) return false;
      hull[1] = p;
      return true;
    }
    hull.insert(turn > 0 ? hull.end() : hull.begin() + 1, p);
    std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end(), lexicographically_less),
                hull.end());
    return true;
  }
  if (hull.size() == 1 && hull[0] == p) return false;
  hull.push_back(p);
  if (hull.size() == 2 && lexicographically_less(p, hull[0])) std::swap(hull[0], hull[1]);
  return true;
}

}  // namespace

// The edges that see p from outside, or that p prolongs, are next to each other: p replaces the
// vertices between them.
bool add_to_convex_hull(std::vector<Vec2>& hull, const Vec2& p, std::size_t& vertex) {
  const std::size_t n = hull.size();
  if (n < 3) return add_to_small_hull(hull, p);
  // Edge i goes from vertex i - 1 to vertex i.
  const auto turn_at_edge = [&](std::size_t i) {
    return orientation(hull[previous(i, n)], hull[i], p);
  };
  std::size_t first = vertex < n ? vertex : 0;
  for (std::size_t asked = 0; turn_at_edge(first) >= 0; first = next(first, n)) {
    if (++asked == n) return false;
  }
  std::size_t last = first;
  while (turn_at_edge(next(last, n)) <= 0) last = next(last, n);
  while (turn_at_edge(previous(first, n)) <= 0) first = previous(first, n);
  const auto at = [&hull](std::size_t i) { return hull.begin() + static_cast<std::ptrdiff_t>(i); };
  // Vertices first .. last - 1 fall, counted around the polygon; p takes the place of the first.
  vertex = first;
  if (first == last) {
    hull.insert(at(first), p);
  } else if (first < last) {
    hull[first] = p;
    hull.erase(at(first + 1), at(last));
  } else {
    hull.resize(first);
    hull.push_back(p);
    hull.erase(hull.begin(), at(last));
    vertex -= last;
  }
  // Only p or the loss of vertex 0 can have changed which vertex is the smallest.
  if (first <= last && first != 0 && lexicographically_less(hull[0], p)) return true;
  begin_with_smallest(hull, vertex);
  return true;
}

Bounds bounding_box(std::span<const Vec2> points) {
  PackedPoint min = packed(points.front());
  PackedPoint max = min;
  for (const Vec2& at : points) {
    const PackedPoint p = packed(at);
    min = p < min ? p : min;
    max = p > max ? p : max;
  }
  return {{min[0], min[1]}, {max[0], max[1]}};
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
