#include "voronaut/planners/mapping/point_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "voronaut/planners/mapping/convex_polygon.h"
#include "voronaut/planners/mapping/require.h"

namespace voronaut {
namespace {

// Large enough that a disc of a vehicle's clearance overlaps few tiles of 8 x 8 cells, small enough
// that a cell on a wall holds few points.
constexpr double kSmallestCellM = 0.21;
constexpr double kSpacingsPerCell = 2;

// Boxes are grown by this share more than asked, so that rounding cannot lose a point on the rim.
constexpr double kRoundingMargin = 1 + 1e-6;

// Of the filter: as many as keep it from being marked where nothing is.
constexpr std::size_t kWordsPerTile = 5;

// Where the start of the first search for the nearest point reaches.
constexpr double kFirstReachCells = 1;

// The square of the distance from a point to a segment, without a division unless it is needed.
class SegmentDistance {
 public:
  SegmentDistance(const Vec2& a, const Vec2& b)
      : a_(a), b_(b), along_(b - a), length_sq_(along_.squaredNorm()) {}

  bool closer_than(const Vec2& p, double distance_sq) const {
    const Vec2 from_a = p - a_;
    const double t = from_a.dot(along_);
    if (t <= 0) return from_a.squaredNorm() < distance_sq;
    if (t >= length_sq_) return (p - b_).squaredNorm() < distance_sq;
    const double area = cross(along_, from_a);
    return area * area < distance_sq * length_sq_;
  }

  double squared(const Vec2& p) const {
    const Vec2 from_a = p - a_;
    const double t = from_a.dot(along_);
    if (t <= 0) return from_a.squaredNorm();
    if (t >= length_sq_) return (p - b_).squaredNorm();
    const double area = cross(along_, from_a);
    return area * area / length_sq_;
  }

 private:
  Vec2 a_;
  Vec2 b_;
  Vec2 along_;
  double length_sq_;
};

}  // namespace

PointIndex::PointIndex(double spacing_m)
    : cells_(std::max(kSmallestCellM, kSpacingsPerCell * spacing_m)),
      marked_reach_m_(NearFilter::kNearCells * cells_.cell_m() / CellTiles::kWidthMargin),
      bounds_{Vec2::Constant(std::numeric_limits<double>::infinity()),
              Vec2::Constant(-std::numeric_limits<double>::infinity())} {}

PointId PointIndex::add(const Vec2& p) {
  require(std::abs(p.x()) + std::abs(p.y()) < kLargestCoordinateM / 2,
          "PointIndex::add: coordinates are not numbers within 1e7 m");
  const auto id = static_cast<PointId>(points_.size());
  const Cell cell = cells_.cell_of(p.x(), p.y());
  const PointId next = cells_.replace_head(cell, id);
  if (next == kNone) mark_occupied(cell);
  points_.push_back(p);
  next_in_cell_.push_back(next);
  grow_to_hold(bounds_, p);
  return id;
}

void PointIndex::mark_occupied(Cell cell) {
  if (near_.words() >= kWordsPerTile * cells_.tiles()) {
    near_.mark_around(cell);
  } else {
    near_.start_over_larger();
    cells_.for_each_occupied([&](Cell occupied) { near_.mark_around(occupied); });
  }
}

PointIndex::Reach PointIndex::close_reach(const Vec2& a, const Vec2& b, double distance_m) const {
  const double margin_m = distance_m * kRoundingMargin;
  return {cells_.cell_of(std::min(a.x(), b.x()) - margin_m, std::min(a.y(), b.y()) - margin_m),
          cells_.cell_of(std::max(a.x(), b.x()) + margin_m, std::max(a.y(), b.y()) + margin_m),
          false};
}

PointIndex::Reach PointIndex::reach(const Vec2& a, const Vec2& b, double distance_m) const {
  const double margin_m = distance_m * kRoundingMargin;
  const double low_x = std::max(std::min(a.x(), b.x()) - margin_m, bounds_.min.x());
  const double low_y = std::max(std::min(a.y(), b.y()) - margin_m, bounds_.min.y());
  const double high_x = std::min(std::max(a.x(), b.x()) + margin_m, bounds_.max.x());
  const double high_y = std::min(std::max(a.y(), b.y()) + margin_m, bounds_.max.y());
  if (!(low_x <= high_x && low_y <= high_y)) return {{}, {}, true};
  return {cells_.cell_of(low_x, low_y), cells_.cell_of(high_x, high_y), false};
}

bool PointIndex::reaches_all_points(const Vec2& p, double distance_m) const {
  const double farthest_sq =
      (p - bounds_.min).cwiseAbs().cwiseMax((p - bounds_.max).cwiseAbs()).squaredNorm();
  return farthest_sq < distance_m * distance_m;
}

template <class Visit>
bool PointIndex::any_point(const Reach& within, const Visit& visit) const {
  if (within.empty) return false;
  return cells_.any_of(within.low, within.high, [&](PointId id) {
    for (; id != kNone; id = next_in_cell_[id]) {
      if (visit(id)) return true;
    }
    return false;
  });
}

PointId PointIndex::nearest_in(const Reach& within, const Vec2& p, double limit_sq) const {
  PointId nearest = kNone;
  any_point(within, [&](PointId id) {
    const double distance_sq = voronaut::distance_sq(points_[id], p);
    if (distance_sq < limit_sq || (distance_sq == limit_sq && nearest != kNone && id < nearest)) {
      nearest = id;
      limit_sq = distance_sq;
    }
    return false;
  });
  return nearest;
}

PointId PointIndex::nearest_closer_than(const Vec2& p, double distance_m) const {
  return nearest_in(reach(p, p, distance_m), p, distance_m * distance_m);
}

PointId PointIndex::nearest(const Vec2& p, double within_m) const {
  for (double reach_m = kFirstReachCells * cells_.cell_m(); reach_m < within_m; reach_m *= 2) {
    const PointId id = nearest_closer_than(p, reach_m);
    if (id != kNone || reaches_all_points(p, reach_m)) return id;
  }
  // Not farther than within_m is closer than the next larger number.
  const double limit_sq =
      std::nextafter(within_m * within_m, std::numeric_limits<double>::infinity());
  return nearest_in(reach(p, p, within_m), p, limit_sq);
}

bool PointIndex::is_clear_in_reach(const Vec2& p, double distance_m) const {
  const double distance_sq = distance_m * distance_m;
  const Reach within =
      distance_m <= marked_reach_m_ ? close_reach(p, p, distance_m) : reach(p, p, distance_m);
  return !any_point(
      within, [&](PointId id) { return voronaut::distance_sq(points_[id], p) < distance_sq; });
}

bool PointIndex::is_clear(const Vec2& a, const Vec2& b, double distance_m) const {
  const SegmentDistance to_segment(a, b);
  const double distance_sq = distance_m * distance_m;
  return !any_point(reach(a, b, distance_m),
                    [&](PointId id) { return to_segment.closer_than(points_[id], distance_sq); });
}

double PointIndex::distance_sq(const Vec2& a, const Vec2& b, double within_m) const {
  const SegmentDistance to_segment(a, b);
  double smallest_sq = within_m * within_m;
  any_point(reach(a, b, within_m), [&](PointId id) {
    smallest_sq = std::min(smallest_sq, to_segment.squared(points_[id]));
    return false;
  });
  return smallest_sq;
}

}  // namespace voronaut
