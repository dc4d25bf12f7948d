#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

// Plain planar shapes and exact distances between them. Metres, world frame W (x, y horizontal).
// Everything that casts rays or measures clearance, of the true world or of the believed one, uses
// these types.
namespace voronaut {

using Vec2 = Eigen::Vector2d;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Circle {
  Vec2 center;
  double radius_m = 0;
};

// A wall without thickness; both ends belong to it.
struct Segment {
  Vec2 a;
  Vec2 b;
};

// Simple polygon (no self-intersection), counter-clockwise, closed from the last vertex to the
// first, solid: its inside is obstacle. Boxes are polygons of four vertices.
struct Polygon {
  std::vector<Vec2> vertices;
};

// Axis-aligned area, both limits included.
struct Bounds {
  Vec2 min;
  Vec2 max;

  bool contains(const Vec2& p) const {
    return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
  }
};

inline Bounds grown(const Bounds& area, double by_m) {
  return {area.min - Vec2::Constant(by_m), area.max + Vec2::Constant(by_m)};
}

// Of at least one point. O(n).
inline Bounds bounds_of(std::span<const Vec2> points) {
  Bounds bounds{points.front(), points.front()};
  for (const Vec2& p : points) {
    bounds.min = bounds.min.cwiseMin(p);
    bounds.max = bounds.max.cwiseMax(p);
  }
  return bounds;
}

// Where a planar body is and where it looks. `heading` is a unit vector; directions are compared by
// cross and dot products, so no angle is ever needed in a decision.
struct Pose2 {
  Vec2 p_world = Vec2::Zero();
  Vec2 heading = Vec2::UnitX();
};

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Whether a convex polygon, corners counter-clockwise, holds p: on its border too. O(corners).
inline bool holds(std::span<const Vec2> convex, const Vec2& p) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2& a = convex[i];
    if (cross(convex[i + 1 < convex.size() ? i + 1 : 0] - a, p - a) < 0) return false;
  }
  return true;
}

// Quarter turn counter-clockwise: the left-hand normal of a direction.
inline Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

inline Vec2 closest_point(const Vec2& p, const Segment& s) {
  const Vec2 along = s.b - s.a;
  const double length_sq = along.squaredNorm();
  if (length_sq == 0) return s.a;
  const double t = std::clamp((p - s.a).dot(along) / length_sq, 0.0, 1.0);
  return s.a + t * along;
}

inline double distance(const Vec2& p, const Segment& s) { return (p - closest_point(p, s)).norm(); }

}  // namespace voronaut
