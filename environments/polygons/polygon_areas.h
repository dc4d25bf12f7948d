#pragma once

#include <string>
#include <vector>

#include "voronaut/environments/shapes/shapes.h"

// What is done with polygons once, when a world is read, drawn or rated: Boost.Geometry's work. Not
// for loops: see shape_index.h.
namespace voronaut {

// A polygon that may have holes. The outer ring is counter-clockwise, holes are clockwise; none
// repeats its first vertex at its end.
struct PolygonArea {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

// The rings turned as they should be. Throws std::invalid_argument with the reason unless they are
// those of one valid polygon (OGC 06-103r4): simple, holes inside, its inside connected.
PolygonArea oriented(PolygonArea area);

// The same area as simple polygons. They are cut from each other along whole lines through the
// holes and share those edges exactly: no ray and no disc passes between them.
std::vector<Polygon> without_holes(const PolygonArea& area);

// The area that polygons cover together: where they overlap or share an edge, no edge is left.
std::vector<PolygonArea> united(const std::vector<Polygon>& polygons);

// The circle as a polygon of so many corners whose edges touch it.
Polygon around(const Circle& circle, int corners);

// How much of the bounds no solid shape covers, from 0 to 1; circles count as polygons of 64
// corners, 0.1 % too large. O(n log n) in the edges.
double free_share(const Bounds& bounds, const Shapes& shapes);

}  // namespace voronaut
