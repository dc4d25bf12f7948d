#pragma once

#include <optional>
#include <vector>

#include "voronaut/planners/voronoi/channel_search.h"
#include "voronaut/planners/voronoi/delaunay.h"
#include "voronaut/planners/voronoi/site_cells.h"

namespace voronaut {

// What a path is pulled taut against. Site k + 4 of the triangulation is point k of the cells.
struct StringObstacles {
  const DelaunayTriangulation& delaunay;
  const SiteCells& cells;
  Bounds domain;
  double radius_m;        // the path bends around circles of this radius
  double check_radius_m;  // and every piece is checked against this one, a little smaller
};

// Shortest path of a disc in a channel: a string from start to goal pulled taut around the circles
// of radius_m about the channel's sites, that is straight pieces along common tangents and arcs.
// Arcs become chords outside the circle: their corners lie where tangents meet, at most 0.5 % of
// radius_m away from it, closer where another circle is close. Empty if the string cannot be pulled
// without touching another site or leaving the domain; then nothing is claimed about the channel.
// O(gates x sites touched).
std::optional<std::vector<Vec2>> pull_string(const StringObstacles& around, const Channel& channel,
                                             const Vec2& start, const Vec2& goal);

// Leaves out what a straight piece can bypass at check_radius_m, first between the vertices, then
// between points strewn along the way: Bhattacharya and Gavrilova's shortcut (their test, printed
// inverted, removes a vertex when the clearance of the bypass is too small). Never longer than the
// path it is given. O(vertices log vertices) checks.
std::vector<Vec2> shorten_by_shortcuts(const StringObstacles& around,
                                       const std::vector<Vec2>& path);

double length_m(const std::vector<Vec2>& path);

}  // namespace voronaut
