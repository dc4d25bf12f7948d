#include "voronaut/planners/mapping/index/point_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "voronaut/planners/mapping/points/convex_polygon.h"
#include "voronaut/planners/mapping/points/require.h"

namespace voronaut {
namespace {

// Large enough that a disc of a vehicle's clearance overlaps few tiles of 8 x 8 cells, small enough
// that a cell on a wall holds few points.
constexpr double kSmallestCellM = 0.21;
constexpr double kSpacingsPerCell = 2;

// Boxes are grown by this share more than asked, so that rounding cannot lose a point on the rim.
constexpr double kDistanceRoundingMargin = 1 + 1e-6;

// The clearance field is walked through in steps not shorter than this; what is closer to points is
// left to them. Longer motions than the longest are left to the points at once.
constexpr double kShortestStepM = 0.1;
constexpr double kLongestWalkM = 1000;

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
      bounds_{Vec2::Constant(std::numeric_limits<double>::infinity()),
              Vec2::Constant(-std::numeric_limits<double>::infinity())} {}

PointId PointIndex::add(const Vec2& p) {
  require(std::abs(p.x()) + std::abs(p.y()) < kLargestCoordinateM / 2,
          "PointIndex::add: coordinates are not numbers within 1e7 m");
  const auto id = static_cast<PointId>(points_.size());
  const Cell cell = cells_.cell_of(p.x(), p.y());
  points_.push_back(p);
  expected_m_ = kNotExpected;
  next_in_cell_.push_back(cells_.replace_head(cell, id));
  grow_to_hold(bounds_, p);
  return id;
}

void PointIndex::expect_checks(double distance_m) const {
  require(distance_m >= 0, "PointIndex::expect_checks: the distance is negative");
  if (distance_m > ClearanceField::kLargestRadiusM) return;
  if (field_.radius_m() != distance_m) field_ = ClearanceField(distance_m);
  for (std::size_t id = field_.points(); id < points_.size(); ++id) field_.add(points_[id]);
  expected_m_ = distance_m;
}

PointIndex::Reach PointIndex::reach(const Vec2& a, const Vec2& b, double distance_m) const {
  const double margin_m = distance_m * kDistanceRoundingMargin;
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
  const double margin_m = distance_m * kDistanceRoundingMargin;
  const Reach around{cells_.cell_of(p.x() - margin_m, p.y() - margin_m),
                     cells_.cell_of(p.x() + margin_m, p.y() + margin_m)};
  return nearest_in(around, p, distance_m * distance_m);
}

PointId PointIndex::nearest(const Vec2& p, double within_m) const {
  for (double reach_m = kFirstReachCells * cells_.cell_m(); reach_m < within_m; reach_m *= 2) {
    const PointId id = nearest_in(reach(p, p, reach_m), p, reach_m * reach_m);
    if (id != kNone || reaches_all_points(p, reach_m)) return id;
  }
  // Not farther than within_m is closer than the next larger number.
  const double limit_sq =
      std::nextafter(within_m * within_m, std::numeric_limits<double>::infinity());
  return nearest_in(reach(p, p, within_m), p, limit_sq);
}

bool PointIndex::is_clear_of_points(const Vec2& p, double distance_m) const {
  const double distance_sq = distance_m * distance_m;
  return !any_point(reach(p, p, distance_m), [&](PointId id) {
    return voronaut::distance_sq(points_[id], p) < distance_sq;
  });
}

// What is asked of a motion.
struct PointIndex::Sweep {
  Sweep(const Vec2& from, const Vec2& to, double clearance_m)
      : to_segment(from, to), a(from), along(to - from), distance_m(clearance_m) {}
  SegmentDistance to_segment;
  Vec2 a;
  Vec2 along;
  double distance_m;
};

bool PointIndex::is_clear_of_points(const Sweep& sweep, const Vec2& from, const Vec2& to) const {
  const double distance_sq = sweep.distance_m * sweep.distance_m;
  return !any_point(reach(from, to, sweep.distance_m), [&](PointId id) {
    return sweep.to_segment.closer_than(points_[id], distance_sq);
  });
}

// A disc as large as the bound at its centre is clear, and with it the swept disc up to where that
// one ends. Around the middle first: mostly that is all.
bool PointIndex::is_clear(const Vec2& a, const Vec2& b, double distance_m) const {
  const Vec2 along = b - a;
  const double length_sq = along.squaredNorm();
  if (!(expected_m_ >= 0) || !(length_sq < kLongestWalkM * kLongestWalkM)) {
    return is_clear_of_points(Sweep(a, b, distance_m), a, b);
  }
  const double around_m = field_.bound_m(a + 0.5 * along) - distance_m;
  if (around_m > 0 && 4 * around_m * around_m >= length_sq) return true;
  return is_clear_but_around_middle(Sweep(a, b, distance_m), std::max(0.0, around_m));
}

bool PointIndex::is_clear_but_around_middle(const Sweep& sweep, double around_m) const {
  const double share_per_m = 1 / std::sqrt(sweep.along.squaredNorm());
  if (!std::isfinite(share_per_m)) return is_clear_of_points(sweep, sweep.a, sweep.a);
  const double around = around_m * share_per_m;
  return is_clear_between(sweep, 0, 0.5 - around, share_per_m) &&
         is_clear_between(sweep, 0.5 + around, 1, share_per_m);
}

// What the bounds cannot tell is left to the points.
bool PointIndex::is_clear_between(const Sweep& sweep, double from, double to,
                                  double share_per_m) const {
  while (from < to) {
    const Vec2 p = sweep.a + from * sweep.along;
    const double step_m = field_.bound_m(p) - sweep.distance_m;
    if (step_m < kShortestStepM) return is_clear_of_points(sweep, p, sweep.a + to * sweep.along);
    from += step_m * share_per_m;
  }
  return true;
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
