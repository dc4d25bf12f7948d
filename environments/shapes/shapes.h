#pragma once

#include <cstddef>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

// Obstacles as plain shapes. Every shape is closed: its boundary belongs to it. Circles and
// polygons are solid, segments are walls without thickness. Metres, world frame W.
namespace voronaut {

struct Shapes {
  std::vector<Circle> circles;
  std::vector<Segment> segments;
  std::vector<Polygon> polygons;

  std::size_t size() const { return circles.size() + segments.size() + polygons.size(); }
  bool empty() const { return size() == 0; }
};

// Throws std::invalid_argument, naming the shape by its kind and index, unless every coordinate is
// finite, every radius is positive and every polygon is simple: at least 3 vertices, no edge of
// length zero, no edge that meets another one but at the vertex they share. Clockwise polygons
// come back counter-clockwise. O(v^2) in the vertices of each polygon.
Shapes validated(Shapes shapes);

// Distance from p to the surface, negative inside a solid.
double signed_distance(const Vec2& p, const Circle& circle);
double signed_distance(const Vec2& p, const Polygon& polygon);  // O(vertices)

// From vertex i to the next one.
inline Segment edge(const Polygon& polygon, std::size_t i) {
  return {polygon.vertices[i], polygon.vertices[i + 1 < polygon.vertices.size() ? i + 1 : 0]};
}

// Whether the ray from p towards +x crosses the edge; half-open in y, so that a vertex counts once.
// A point lies inside a polygon if it crosses an odd number of its edges.
inline bool crosses_rightward_ray(const Segment& e, const Vec2& p) {
  if ((e.a.y() > p.y()) == (e.b.y() > p.y())) return false;
  return (cross(e.b - e.a, p - e.a) > 0) == (e.b.y() > e.a.y());
}

// Whether p lies inside; either answer on the boundary. O(vertices).
bool encloses(const Polygon& polygon, const Vec2& p);

// Distance from p to the nearest shape: +infinity without shapes; inside solids it is negative,
// minus the depth in the one where p is deepest. O(shapes); ShapeIndex gives the same in O(1).
double clearance_m(const Shapes& shapes, const Vec2& p);

// Whether two segments have a point in common.
bool meet(const Segment& s, const Segment& t);
// Smallest distance between the points of two segments, 0 if they meet.
double distance(const Segment& s, const Segment& t);

// Rectangle of length (along `heading`, a unit vector) and width around its centre.
Polygon box(const Vec2& center, double length_m, double width_m,
            const Vec2& heading = Vec2::UnitX());
Polygon box(const Bounds& area);

// Smallest axis-aligned area that holds the shape.
Bounds bounds_of(const Circle& circle);
Bounds bounds_of(const Segment& segment);
Bounds bounds_of(const Polygon& polygon);

}  // namespace voronaut
