#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/voronoi/delaunay.h"

// The part of the Voronoi diagram along which a disc can move: Bhattacharya and Gavrilova, IEEE
// Robotics & Automation Magazine 15(2), 2008, https://doi.org/10.1109/MRA.2008.921540, made exact
// at the border of the area.
//
// The diagram is cut at the border of a convex domain, and the border becomes part of the graph.
// Moving away from the closest site until the cell or the domain ends never lowers the clearance
// and is continuous, so two points of clearance >= r are connected at that clearance inside the
// domain if and only if their images on the graph are, with every edge kept whose own clearance to
// its sites is >= r. The border takes the place of the frame points of the literature: it is what
// leads around the outside, and it may be tighter than a frame could be.
namespace voronaut {

using VertexId = std::int32_t;

class VoronoiGraph {
 public:
  struct Edge {
    VertexId u;
    VertexId v;
    double length_m;
  };
  struct Neighbour {
    VertexId vertex;
    double length_m;
  };
  // A piece of the border between two neighbouring vertices on it, counter-clockwise.
  struct BorderPiece {
    double station_m;  // where it begins, along the border from the lower left corner
    VertexId from;
    VertexId to;
    SiteId site;  // whose cell it bounds
    bool clear;
  };

  // The corners of the triangulation's frame must be 2 radius_m or farther from the domain, so that
  // they bind nothing. O(sites + border vertices log border vertices); no allocation once the
  // buffers have grown.
  void build(const DelaunayTriangulation& delaunay, const Bounds& domain, double radius_m);

  std::span<const Vec2> vertices() const { return vertices_; }
  std::span<const Edge> edges() const { return edges_; }  // those that are clear
  std::span<const Neighbour> neighbours(VertexId v) const {
    return {neighbours_.data() + first_[v], neighbours_.data() + first_[v + 1]};
  }

  // Ends of the Voronoi edge dual to a Delaunay edge, after cutting, clear or not; {-1, -1} if it
  // lies outside the domain.
  std::array<VertexId, 2> dual(HalfEdgeId h) const {
    const HalfEdgeId g = delaunay_->twin(h);
    return dual_[g >= 0 && g < h ? g : h];
  }
  const BorderPiece& border_piece(const Vec2& on_border) const;
  std::span<const BorderPiece> border() const { return border_; }

  // Whether the straight piece keeps radius_m from a site.
  bool is_clear(const Vec2& p, const Vec2& q, SiteId s) const;

  const Bounds& domain() const { return domain_; }
  double radius_m() const { return radius_m_; }

 private:
  struct BorderVertex {
    double station_m;
    VertexId vertex;
    std::array<SiteId, 2> sites;  // -1 at the corners of the domain
  };

  // What an edge between two vertices inside the domain was found to be, by the states of its
  // triangles.
  struct Seen {
    std::uint64_t state = 0, twin_state = 0;
    bool passable = false;
  };

  void add_dual(HalfEdgeId h);
  bool add_seen(HalfEdgeId h);
  VertexId vertex_in(TriangleId t);
  VertexId add_border_vertex(const Vec2& p, std::array<SiteId, 2> sites);
  void add_border();
  SiteId site_along(std::size_t i, SiteId previous) const;
  void add_edge(VertexId u, VertexId v);
  void index_neighbours();
  double station_m(const Vec2& on_border) const;

  const DelaunayTriangulation* delaunay_ = nullptr;
  Bounds domain_{Vec2::Zero(), Vec2::Zero()};
  double radius_m_ = 0;
  std::vector<Vec2> vertices_;
  std::vector<Edge> edges_;
  std::vector<std::int32_t> first_;
  std::vector<Neighbour> neighbours_;
  std::vector<VertexId> vertex_of_triangle_;
  std::vector<std::array<VertexId, 2>> dual_;
  std::vector<Seen> seen_;  // by half-edge; of this domain and radius
  std::vector<BorderVertex> border_vertices_;
  std::vector<BorderPiece> border_;
};

}  // namespace voronaut
