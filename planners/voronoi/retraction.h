#pragma once

#include <array>
#include <functional>
#include <vector>

#include "voronaut/planners/voronoi/voronoi_graph.h"

namespace voronaut {

// Where a point lands on the Voronoi graph when it moves straight away from its closest site: the
// first border of that site's whole cell, or of the domain. On the way the clearance only grows.
struct Retraction {
  SiteId site = -1;
  double clearance_m = 0;  // from the point to that site
  Vec2 landing = Vec2::Zero();
  std::array<VertexId, 2> ends{-1, -1};  // of the edge it lands on
  std::array<SiteId, 2> sites{-1, -1};   // of that edge; equal on the border of the domain
};

// p must lie in the graph's domain. O(edges of the cell), never bounded by a number of neighbours.
Retraction retract(const DelaunayTriangulation& delaunay, const VoronoiGraph& graph, const Vec2& p);

// A way from a point to a vertex of the graph.
struct Lead {
  std::vector<Vec2> points;  // from the point to the vertex, both included
  VertexId vertex = -1;
  double length_m = 0;
};

using MotionCheck = std::function<bool(const Vec2&, const Vec2&)>;

// All ways by which a retracted point that has the full clearance reaches the graph: one or two, or
// none if it sits in a pocket that is closed on both sides.
std::vector<Lead> leads(const VoronoiGraph& graph, const Retraction& r, const Vec2& p);

// The same for a point that is too close to a site already: pieces of the diagram near it that are
// not clear are admitted where `motion_is_clear`, which knows what is relaxed, allows them.
std::vector<Lead> relaxed_leads(const DelaunayTriangulation& delaunay, const VoronoiGraph& graph,
                                const Retraction& r, const Vec2& p,
                                const MotionCheck& motion_is_clear);

}  // namespace voronaut
