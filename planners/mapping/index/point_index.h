#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/index/cell_tiles.h"
#include "voronaut/planners/mapping/index/clearance_field.h"
#include "voronaut/planners/mapping/points/scan_cluster.h"

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
  // swept along it, would touch.
  bool is_clear(const Vec2& p, double distance_m) const {
    if (distance_m == expected_m_) {
      const auto disc = field_.disc_at(p);
      if (disc != ClearanceField::Disc::undecided) return disc == ClearanceField::Disc::clear;
    }
    return is_clear_of_points(p, distance_m);
  }
  bool is_clear(const Vec2& a, const Vec2& b, double distance_m) const;
  // Makes the two fast for this distance, until the next point is added, by a look at the
  // surroundings of the points added since the last call (of all, if the distance is another). For
  // whoever is about to ask often; the answers are the same without. Not while another thread asks.
  // Does nothing for distances above ClearanceField::kLargestRadiusM.
  void expect_checks(double distance_m) const;

  // Square of the smallest distance from the segment a-b to a point, at most within_m squared.
  double distance_sq(const Vec2& a, const Vec2& b, double within_m) const;

 private:
  static constexpr double kNotExpected = std::numeric_limits<double>::quiet_NaN();
  struct Sweep;
  struct Reach {
    Cell low;
    Cell high;
    bool empty = false;
  };
  // The cells of the box around a-b grown by distance_m, as far as there are points at all.
  Reach reach(const Vec2& a, const Vec2& b, double distance_m) const;
  bool is_clear_of_points(const Vec2& p, double distance_m) const;
  bool is_clear_of_points(const Sweep& sweep, const Vec2& from, const Vec2& to) const;
  bool is_clear_but_around_middle(const Sweep& sweep, double around_m) const;
  bool is_clear_between(const Sweep& sweep, double from, double to, double share_per_m) const;
  bool reaches_all_points(const Vec2& p, double distance_m) const;
  PointId nearest_in(const Reach& within, const Vec2& p, double limit_sq) const;

  template <class Visit>
  bool any_point(const Reach& within, const Visit& visit) const;

  CellTiles cells_;
  Bounds bounds_;  // of all points
  std::vector<Vec2> points_;
  std::vector<PointId> next_in_cell_;
  // They save time and change no answer.
  mutable ClearanceField field_{0};
  mutable double expected_m_ = kNotExpected;  // the field's radius while it knows all points
};

}  // namespace voronaut
