#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/voronoi/delaunay.h"

namespace voronaut {

// Where a path bends: around a site, which it has on its left or on its right.
struct Turn {
  SiteId site = -1;
  bool on_left = false;
  std::size_t gate = 0;  // index into the gates of the channel
};

// Triangles that a path passes through, as the edges that it crosses, and where it bends on the
// way.
struct Channel {
  std::vector<HalfEdgeId> gates;  // each as seen from the triangle that is left
  std::vector<Turn> turns;
  double length_m =
      0;  // of the path that cuts the corners of its arcs: a lower bound, nearly tight
};

// Shortest channel for a disc among the Delaunay triangles of the known points: the dual of the
// Voronoi graph, searched without committing to vertices.
//
// A disc of radius r passes between two sites if they are 2 r apart or more, and then crosses the
// part of the edge between them that is r away from both. Polyanya (Cui, Harabor and Grastien,
// IJCAI 2017, https://doi.org/10.24963/ijcai.2017/70) finds the shortest path through such gates
// exactly: its search nodes are intervals of gates that are visible from a common root. The ends of
// the gates around a site lie on its circle of radius r, so the path follows chords of the arcs
// that the disc will really take; what remains is to pull it taut around the circles.
class ChannelSearch {
 public:
  // Shortest channel from start to goal within the domain, unless it is longer than bound_m or
  // takes more than max_nodes search nodes. start and goal must lie in the domain.
  std::optional<Channel> find(const DelaunayTriangulation& delaunay, const Bounds& domain,
                              double radius_m, const Vec2& start, const Vec2& goal, double bound_m);

  std::size_t nodes() const { return nodes_.size(); }

 private:
  enum class Bend : std::int8_t { none, left, right };

  // The part of the gate between two edges' ends that the disc can use.
  struct Gate {
    Vec2 left;
    Vec2 right;
    bool left_corner;  // an end on a site's circle, around which a path may bend
    bool right_corner;
    bool open;

    Vec2 at(double t) const {
      if (t <= 0) return left;
      return t >= 1 ? right : Vec2(left + t * (right - left));
    }
  };

  struct Node {
    Vec2 root;
    Vec2 left;  // ends of the visible interval, as seen from the root
    Vec2 right;
    double cost_m;  // from the start to the root
    HalfEdgeId gate;
    HalfEdgeId root_corner;  // key of the root, -1 for the start
    std::int32_t parent;
    Bend bend;  // how the root differs from the parent's: it is an end of the parent's interval
    bool left_corner;
    bool right_corner;
    bool at_goal;
  };

  // The cheapest way known to a corner, and the node that found it.
  struct CornerRecord {
    double cost_m;
    std::int32_t parent;
  };

  Gate gate(HalfEdgeId h) const;
  void start_from(TriangleId t);
  void expand(std::int32_t index);
  void cross(std::int32_t index, HalfEdgeId exit);
  void finish(std::int32_t index);
  void push(const Node& node);
  bool turn(Node& child, std::int32_t index, Bend bend);
  double estimate_m(const Node& node) const;
  Channel trace(std::int32_t index) const;

  struct Entry {
    double estimate_m;
    std::int32_t node;
    bool operator<(const Entry& o) const {
      return estimate_m != o.estimate_m ? estimate_m > o.estimate_m : node > o.node;
    }
  };

  const DelaunayTriangulation* delaunay_ = nullptr;
  Bounds domain_{Vec2::Zero(), Vec2::Zero()};
  double radius_m_ = 0;
  double bound_m_ = 0;
  Vec2 start_ = Vec2::Zero();
  Vec2 goal_ = Vec2::Zero();
  TriangleId goal_triangle_ = -1;
  std::vector<Node> nodes_;
  std::vector<Entry> heap_;
  std::vector<CornerRecord> corner_;  // by a corner's key
};

}  // namespace voronaut
