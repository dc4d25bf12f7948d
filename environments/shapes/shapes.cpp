#include "voronaut/environments/shapes/shapes.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "voronaut/environments/shapes/polygon_validity.h"

namespace voronaut {
namespace {

[[noreturn]] void reject(const char* kind, std::size_t index, const std::string& why) {
  throw std::invalid_argument(std::string(kind) + " " + std::to_string(index) + " " + why);
}

void require_finite(const char* kind, std::size_t index, const Vec2& p) {
  if (!std::isfinite(p.x()) || !std::isfinite(p.y())) {
    reject(kind, index, "has a coordinate that is not finite");
  }
}

double twice_area(const Polygon& polygon) {
  // Relative to a vertex, so that a small polygon far from the origin keeps its digits.
  const Vec2& origin = polygon.vertices.front();
  double sum = 0;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    const Segment e = edge(polygon, i);
    sum += cross(e.a - origin, e.b - origin);
  }
  return sum;
}

int side(const Segment& s, const Vec2& p) {
  const double area = cross(s.b - s.a, p - s.a);
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

bool spans(const Segment& s, const Vec2& p) {
  return p.x() >= std::min(s.a.x(), s.b.x()) && p.x() <= std::max(s.a.x(), s.b.x()) &&
         p.y() >= std::min(s.a.y(), s.b.y()) && p.y() <= std::max(s.a.y(), s.b.y());
}

void require_simple(const Polygon& polygon, std::size_t index) {
  const std::size_t n = polygon.vertices.size();
  if (n < 3) reject("polygon", index, "has fewer than 3 vertices");
  for (const Vec2& v : polygon.vertices) require_finite("polygon", index, v);
  for (std::size_t i = 0; i < n; ++i) {
    const Segment e = edge(polygon, i);
    if (e.a == e.b) reject("polygon", index, "repeats vertex " + std::to_string(i));
  }
  if (const std::string problem = validity_problem(polygon); !problem.empty())
    reject("polygon", index, problem);
}

}  // namespace

Shapes validated(Shapes shapes) {
  for (std::size_t i = 0; i < shapes.circles.size(); ++i) {
    const Circle& circle = shapes.circles[i];
    require_finite("circle", i, circle.center);
    if (!(circle.radius_m > 0) || !std::isfinite(circle.radius_m)) {
      reject("circle", i, "has a radius that is not positive and finite");
    }
  }
  for (std::size_t i = 0; i < shapes.segments.size(); ++i) {
    require_finite("segment", i, shapes.segments[i].a);
    require_finite("segment", i, shapes.segments[i].b);
  }
  for (std::size_t i = 0; i < shapes.polygons.size(); ++i) {
    Polygon& polygon = shapes.polygons[i];
    require_simple(polygon, i);
    const double area = twice_area(polygon);
    if (area == 0) reject("polygon", i, "has no area");
    if (area < 0) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  }
  return shapes;
}

double signed_distance(const Vec2& p, const Circle& circle) {
  return (p - circle.center).norm() - circle.radius_m;
}

double signed_distance(const Vec2& p, const Polygon& polygon) {
  double nearest_m = kInfinity;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    nearest_m = std::min(nearest_m, distance(p, edge(polygon, i)));
  }
  return encloses(polygon, p) ? -nearest_m : nearest_m;
}

bool encloses(const Polygon& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
    if (crosses_rightward_ray(edge(polygon, i), p)) inside = !inside;
  }
  return inside;
}

double clearance_m(const Shapes& shapes, const Vec2& p) {
  double nearest_m = kInfinity;
  for (const Circle& c : shapes.circles) nearest_m = std::min(nearest_m, signed_distance(p, c));
  for (const Segment& s : shapes.segments) nearest_m = std::min(nearest_m, distance(p, s));
  for (const Polygon& g : shapes.polygons) nearest_m = std::min(nearest_m, signed_distance(p, g));
  return nearest_m;
}

bool meet(const Segment& s, const Segment& t) {
  const int sa = side(t, s.a);
  const int sb = side(t, s.b);
  const int ta = side(s, t.a);
  const int tb = side(s, t.b);
  if (sa * sb < 0 && ta * tb < 0) return true;
  return (sa == 0 && spans(t, s.a)) || (sb == 0 && spans(t, s.b)) || (ta == 0 && spans(s, t.a)) ||
         (tb == 0 && spans(s, t.b));
}

double distance(const Segment& s, const Segment& t) {
  if (meet(s, t)) return 0;
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

Polygon box(const Vec2& center, double length_m, double width_m, const Vec2& heading) {
  const Vec2 ahead = heading * (length_m / 2);
  const Vec2 left = left_of(heading) * (width_m / 2);
  return {
      {center - ahead - left, center + ahead - left, center + ahead + left, center - ahead + left}};
}

Polygon box(const Bounds& area) {
  return {{area.min, Vec2(area.max.x(), area.min.y()), area.max, Vec2(area.min.x(), area.max.y())}};
}

Bounds bounds_of(const Circle& circle) {
  const Vec2 reach = Vec2::Constant(circle.radius_m);
  return {circle.center - reach, circle.center + reach};
}

Bounds bounds_of(const Segment& segment) {
  return {segment.a.cwiseMin(segment.b), segment.a.cwiseMax(segment.b)};
}

Bounds bounds_of(const Polygon& polygon) {
  Bounds area{polygon.vertices.front(), polygon.vertices.front()};
  for (const Vec2& v : polygon.vertices) {
    area.min = area.min.cwiseMin(v);
    area.max = area.max.cwiseMax(v);
  }
  return area;
}

}  // namespace voronaut
