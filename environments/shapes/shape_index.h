#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "voronaut/environments/shapes/cell_grid.h"
#include "voronaut/environments/shapes/shapes.h"

namespace voronaut {

// Shapes in a uniform cell list, so that a question about one place costs what lies there and not
// what the world holds. Keeps its own copy of the shapes; immutable, safe to share.
//
// Circles and edges are the primitives: edges are the segments, in order, then the edges of the
// polygons. A primitive is listed in every cell that it (or the box around a circle) touches.
class ShapeIndex {
 public:
  ShapeIndex() = default;  // no shapes
  // Expects validated shapes. cell_m = 0 lets the density of primitives choose. O(shapes + cells),
  // and there are at most 5 cells per primitive plus a constant.
  explicit ShapeIndex(const Shapes& shapes, double cell_m = 0);

  std::span<const Circle> circles() const { return circles_; }
  std::span<const Segment> edges() const { return edges_; }

  // min(within_m, distance from p to the nearest shape), negative inside solids as clearance_m of
  // shapes.h defines it. O(primitives in reach).
  double clearance_m(const Vec2& p,
                     double within_m = std::numeric_limits<double>::infinity()) const;
  // Whether p lies inside a polygon; either answer on its boundary. O(vertices of those near p).
  bool is_inside_polygon(const Vec2& p) const;
  // Whether a disc moved from a to b stays at least radius_m > 0 from every shape: exact, no steps;
  // contact at exactly radius_m is clear. O(primitives within reach of the cells it sweeps).
  bool segment_is_clear(const Vec2& a, const Vec2& b, double radius_m) const;

  // Calls circle(index) and edge(index) for every primitive that may reach into `area`; seldom one
  // comes twice.
  template <class OnCircle, class OnEdge>
  void visit(const Bounds& area, OnCircle&& circle, OnEdge&& edge) const;

  // Walks the cells along the ray p + t direction, 0 <= t <= range_m, and calls circle(index) and
  // edge(index) for what they list (a primitive once per cell). done(t) is asked at the end of each
  // cell, t being where the ray leaves it: true ends the walk. `direction` is a unit vector.
  template <class OnCircle, class OnEdge, class Done>
  void walk(const Vec2& p, const Vec2& direction, double range_m, OnCircle&& circle, OnEdge&& edge,
            Done&& done) const;

 private:
  struct Solid {  // a polygon as a run of edges
    std::uint32_t first_edge, last_edge;
  };
  // What each cell lists, cell after cell in one array.
  struct CellLists {
    std::vector<std::uint32_t> start;  // cells + 1
    std::vector<std::uint32_t> entry;
  };

  void lay_out_cells(double cell_m);
  template <class ForEach>
  CellLists list(ForEach&& each) const;
  template <class OnCircle, class OnEdge>
  void call(std::uint32_t id, OnCircle& circle, OnEdge& edge) const;
  double solid_distance(const Solid& solid, const Vec2& p) const;
  void add_edges(const Polygon& polygon);
  double nearest_in_cell(std::size_t cell, const Vec2& p) const;
  double nearest_in_ring(int column, int row, int ring, const Vec2& p) const;

  std::vector<Circle> circles_;
  std::vector<Segment> edges_;
  std::vector<Solid> solids_;
  CellGrid grid_;
  CellLists primitives_;  // circle i is i, edge i is circles + i
  CellLists solids_at_;   // polygons whose bounding box touches the cell
};

template <class OnCircle, class OnEdge>
inline void ShapeIndex::call(std::uint32_t id, OnCircle& circle, OnEdge& edge) const {
  const auto circle_count = static_cast<std::uint32_t>(circles_.size());
  if (id < circle_count) {
    circle(id);
  } else {
    edge(id - circle_count);
  }
}

template <class OnCircle, class OnEdge>
void ShapeIndex::visit(const Bounds& area, OnCircle&& circle, OnEdge&& edge) const {
  std::array<std::uint32_t, 64> recent;
  recent.fill(std::numeric_limits<std::uint32_t>::max());
  const CellGrid::Range range = grid_.cells_in(area);
  if (range.x0 > range.x1) return;
  for (int y = range.y0; y <= range.y1; ++y) {
    // The cells of a row are neighbours in the lists too.
    const std::uint32_t end = primitives_.start[grid_.cell(range.x1, y) + 1];
    for (std::uint32_t k = primitives_.start[grid_.cell(range.x0, y)]; k < end; ++k) {
      const std::uint32_t id = primitives_.entry[k];
      if (std::exchange(recent[id % recent.size()], id) != id) call(id, circle, edge);
    }
  }
}

template <class OnCircle, class OnEdge, class Done>
void ShapeIndex::walk(const Vec2& p, const Vec2& direction, double range_m, OnCircle&& circle,
                      OnEdge&& edge, Done&& done) const {
  for (CellGrid::Walk at(grid_, p, direction, range_m); at.inside(); at.advance()) {
    const std::size_t here = grid_.cell(at.x(), at.y());
    for (std::uint32_t k = primitives_.start[here]; k < primitives_.start[here + 1]; ++k) {
      call(primitives_.entry[k], circle, edge);
    }
    if (done(at.leave_m())) return;
  }
}

}  // namespace voronaut
