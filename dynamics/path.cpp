#include "voronaut/dynamics/path.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include <sleef.h>

namespace voronaut {
namespace {

using Eigen::Vector2d;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kJointTolerance_m = 1e-6;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "Path: %s\n", what);
  std::abort();
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double radius_m(const PathSegment& arc) { return (arc.start - arc.center).norm(); }

// Angle from the arc's start to the direction of p, along the arc's sense, in [0, 2 pi).
double sweep_rad(const PathSegment& arc, const Vector2d& p) {
  const Vector2d from = arc.start - arc.center;
  const Vector2d to = p - arc.center;
  const double left = Sleef_cinz_atan2d1_u10purec(cross(from, to), from.dot(to));
  const double along = arc.counter_clockwise ? left : -left;
  return along < 0 ? along + kTwoPi : along;
}

double length_of(const PathSegment& segment) {
  if (segment.kind == PathSegment::Kind::line) return (segment.end - segment.start).norm();
  const double radius = radius_m(segment);
  require(std::abs((segment.end - segment.center).norm() - radius) <= kJointTolerance_m,
          "an arc's ends differ in distance from its centre");
  if (segment.start == segment.end) return kTwoPi * radius;
  return sweep_rad(segment, segment.end) * radius;
}

// Direction from an arc's centre to its point at `offset_m` from its start.
Vector2d radial_at(const PathSegment& arc, double offset_m) {
  const double radius = radius_m(arc);
  const double angle = (arc.counter_clockwise ? offset_m : -offset_m) / radius;
  const Sleef_double_2 sc = Sleef_cinz_sincosd1_u10purec(angle);
  const Vector2d r = (arc.start - arc.center) / radius;
  return {sc.y * r.x() - sc.x * r.y(), sc.x * r.x() + sc.y * r.y()};
}

Vector2d point_on(const PathSegment& segment, double offset_m) {
  if (offset_m <= 0) return segment.start;
  if (offset_m >= segment.length_m) return segment.end;
  if (segment.kind == PathSegment::Kind::line) {
    return segment.start + (segment.end - segment.start) * (offset_m / segment.length_m);
  }
  return segment.center + radius_m(segment) * radial_at(segment, offset_m);
}

// Arc length from the segment's start of its point closest to p, within [from_m, to_m].
double closest_offset(const PathSegment& segment, const Vector2d& p, double from_m, double to_m) {
  if (segment.kind == PathSegment::Kind::line) {
    const Vector2d along = segment.end - segment.start;
    return std::clamp(along.dot(p - segment.start) / segment.length_m, from_m, to_m);
  }
  const double offset = sweep_rad(segment, p) * radius_m(segment);
  if (from_m <= offset && offset <= to_m) return offset;
  const double to_first = (point_on(segment, from_m) - p).squaredNorm();
  const double to_last = (point_on(segment, to_m) - p).squaredNorm();
  return to_first <= to_last ? from_m : to_m;
}

// The segment that holds a station; at a joint the one that starts there.
std::size_t index_at(const std::vector<double>& starts_m, double station_m) {
  const auto next = std::upper_bound(starts_m.begin(), starts_m.end(), station_m);
  return next == starts_m.begin() ? 0 : static_cast<std::size_t>(next - starts_m.begin()) - 1;
}

}  // namespace

Path Path::through(const std::vector<Vector2d>& points) {
  Path path;
  if (points.size() > 1) {
    path.segments_.reserve(points.size() - 1);
    path.starts_m_.reserve(points.size() - 1);
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.append({.start = points[i - 1], .end = points[i]});
  }
  return path;
}

void Path::append(const PathSegment& segment) {
  require(empty() || (back() - segment.start).norm() <= kJointTolerance_m,
          "a segment starts away from the end of the path");
  const double length = length_of(segment);
  if (length == 0) return;
  starts_m_.push_back(length_m());
  segments_.push_back(segment);
  segments_.back().length_m = length;
}

Vector2d Path::point_at(double station_m) const {
  require(!empty(), "an empty path has no points");
  const std::size_t i = index_at(starts_m_, station_m);
  return point_on(segments_[i], station_m - starts_m_[i]);
}

const PathSegment& Path::segment_at(double station_m) const {
  require(!empty(), "an empty path has no segments");
  return segments_[index_at(starts_m_, station_m)];
}

Vector2d Path::direction_at(double station_m) const {
  require(!empty(), "an empty path has no direction");
  const std::size_t i = index_at(starts_m_, station_m);
  const PathSegment& segment = segments_[i];
  if (segment.kind == PathSegment::Kind::line) {
    return (segment.end - segment.start) / segment.length_m;
  }
  const double offset = std::clamp(station_m - starts_m_[i], 0.0, segment.length_m);
  const Vector2d r = radial_at(segment, offset);
  return segment.counter_clockwise ? Vector2d(-r.y(), r.x()) : Vector2d(r.y(), -r.x());
}

PathProjection Path::project(const Vector2d& p, double from_m, double to_m) const {
  require(!empty(), "an empty path has no projection");
  const double first_m = std::clamp(from_m, 0.0, length_m());
  const double last_m = std::clamp(to_m, first_m, length_m());
  PathProjection best{.distance_m = std::numeric_limits<double>::infinity()};
  for (std::size_t i = index_at(starts_m_, first_m); i < segments_.size() && starts_m_[i] <= last_m;
       ++i) {
    const double offset = closest_offset(segments_[i], p, std::max(first_m - starts_m_[i], 0.0),
                                         std::min(last_m - starts_m_[i], segments_[i].length_m));
    const double distance = (point_on(segments_[i], offset) - p).norm();
    if (distance < best.distance_m) {
      best = {.station_m = starts_m_[i] + offset, .distance_m = distance, .segment = i};
    }
  }
  return best;
}

}  // namespace voronaut
