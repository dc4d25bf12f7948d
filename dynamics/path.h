#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace voronaut {

// One segment of a path: a straight line or a circular arc, in the world plane.
struct PathSegment {
  enum class Kind { line, arc };

  Kind kind = Kind::line;
  Eigen::Vector2d start;
  Eigen::Vector2d end;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  // arcs only
  bool counter_clockwise = true;                     // arcs only
  double length_m = 0;
};

// Where a point projects onto a path.
struct PathProjection {
  double station_m = 0;  // arc length from the start of the path
  double distance_m = 0;
  std::size_t segment = 0;
};

// What a planner produced and a vehicle follows: connected segments with arc length. Planners make
// lines; the cart's regulator follows arcs as well, from the coefficients of each segment.
class Path {
 public:
  Path() = default;

  // Straight segments between consecutive points; repeated points are skipped.
  static Path through(const std::vector<Eigen::Vector2d>& points);

  // Adds a segment that starts where the path ends (within 1e-6 m, else abort) and computes its
  // length_m. A line of no length is skipped; an arc whose end is its start is the full circle.
  void append(const PathSegment& segment);

  bool empty() const { return segments_.empty(); }
  double length_m() const {
    return starts_m_.empty() ? 0 : starts_m_.back() + segments_.back().length_m;
  }
  const std::vector<PathSegment>& segments() const { return segments_; }
  Eigen::Vector2d front() const { return segments_.front().start; }
  Eigen::Vector2d back() const { return segments_.back().end; }

  // Point at an arc length, clamped to the path. O(log n).
  Eigen::Vector2d point_at(double station_m) const;
  // The segment that holds an arc length, clamped to the path; at a joint the one that starts
  // there.
  const PathSegment& segment_at(double station_m) const;
  // Unit direction of travel at an arc length.
  Eigen::Vector2d direction_at(double station_m) const;
  // Closest point of the part of the path in [from_m, to_m]: following a path means projecting on
  // what comes next, never on the whole, or a hairpin sends the vehicle back. O(segments in it).
  PathProjection project(const Eigen::Vector2d& p, double from_m, double to_m) const;

 private:
  std::vector<PathSegment> segments_;
  std::vector<double> starts_m_;  // arc length at which each segment starts
};

}  // namespace voronaut
