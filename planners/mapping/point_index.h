#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/cell_tiles.h"
#include "voronaut/planners/mapping/near_filter.h"
#include "voronaut/planners/mapping/scan_cluster.h"

namespace voronaut {

// Points that only ever are added, in chains per cell of a hashed grid. Every query costs the cells
// in its reach, however many points there are elsewhere. Answers are those of a search through all
// points; "closer" is strict, so a point at exactly the given distance does not count.
class PointIndex {
 public:
  static constexpr PointId kNone = 0xffff'ffff;
  static constexpr double kLargestCoordinateM = 2e7;

  // spacing_m: how close the points typically lie to each other.
  explicit PointIndex(double spacing_m);

  // Coordinates that are NaN or add up to more than 1e7 m are a programmer error.
  PointId add(const Vec2& p);

  std::span<const Vec2> points() const { return points_; }
  std::size_t size() const { return points_.size(); }
  const Vec2& operator[](PointId id) const { return points_[id]; }

  // The nearest point of those closer than distance_m, the earliest added of equally close ones;
  // kNone if there is none. For short distances: looks at all cells in reach at once.
  PointId nearest_closer_than(const Vec2& p, double distance_m) const;
  // The same for distances up to infinity (not farther than within_m): looks around p first.
  PointId nearest(const Vec2& p, double within_m) const;

  // True if no point is closer than distance_m to p, or to the segment a-b: what a disc there, or
  // swept along it, would touch. Most of the plane is told by one bit.
  bool is_clear(const Vec2& p, double distance_m) const {
    if (distance_m <= marked_reach_m_ && !near_.may_be_near(cells_.cell_of(p.x(), p.y()))) {
      return true;
    }
    return is_clear_in_reach(p, distance_m);
  }
  bool is_clear(const Vec2& a, const Vec2& b, double distance_m) const;
  // Square of the smallest distance from the segment a-b to a point, at most within_m squared.
  double distance_sq(const Vec2& a, const Vec2& b, double within_m) const;

 private:
  struct Reach {
    Cell low;
    Cell high;
    bool empty = false;
  };
  // The cells of the box around a-b grown by distance_m, as far as there are points at all.
  Reach reach(const Vec2& a, const Vec2& b, double distance_m) const;
  // The same for distances up to marked_reach_m_, not cut to where there are points.
  Reach close_reach(const Vec2& a, const Vec2& b, double distance_m) const;

  void mark_occupied(Cell cell);
  bool is_clear_in_reach(const Vec2& p, double distance_m) const;
  bool reaches_all_points(const Vec2& p, double distance_m) const;
  PointId nearest_in(const Reach& within, const Vec2& p, double limit_sq) const;

  template <class Visit>
  bool any_point(const Reach& within, const Visit& visit) const;

  CellTiles cells_;
  NearFilter near_;
  // Up to this distance a place whose cell is not near has no point.
  double marked_reach_m_;
  Bounds bounds_;  // of all points
  std::vector<Vec2> points_;
  std::vector<PointId> next_in_cell_;
};

}  // namespace voronaut
