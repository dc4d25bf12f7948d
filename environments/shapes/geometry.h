#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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

// Where a planar body is and where it looks. `heading` is a unit vector; directions are compared by
// cross and dot products, so no angle is ever needed in a decision.
struct Pose2 {
  Vec2 p_world = Vec2::Zero();
  Vec2 heading = Vec2::UnitX();
};

inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

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
