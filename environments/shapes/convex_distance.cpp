#include "voronaut/environments/shapes/convex_distance.h"

namespace voronaut {
namespace {

Segment side_of(std::span<const Vec2> convex, std::size_t i) {
  return {convex[i], convex[i + 1 < convex.size() ? i + 1 : 0]};
}

}  // namespace

double distance(std::span<const Vec2> convex, const Vec2& p) {
  if (holds(convex, p)) return 0;
  double nearest_m = kInfinity;
  for (std::size_t i = 0; i < convex.size(); ++i)
    nearest_m = std::min(nearest_m, distance(p, side_of(convex, i)));
  return nearest_m;
}

double distance(std::span<const Vec2> convex, const Segment& s) {
  if (holds(convex, s.a)) return 0;
  double nearest_m = kInfinity;
  for (std::size_t i = 0; i < convex.size(); ++i)
    nearest_m = std::min(nearest_m, distance(s, side_of(convex, i)));
  return nearest_m;
}

double distance(std::span<const Vec2> convex, const Circle& circle) {
  return std::max(0.0, distance(convex, circle.center) - circle.radius_m);
}

double clearance_m(const ShapeIndex& shapes, std::span<const Vec2> convex, double within_m) {
  if (shapes.is_inside_polygon(convex.front())) return 0;
  // The nearest shape is no farther from the polygon than from its first corner.
  const double reach_m = std::min(within_m, std::max(0.0, shapes.clearance_m(convex.front())));
  double nearest_m = reach_m;
  if (reach_m == kInfinity) return reach_m;
  shapes.visit(
      grown(bounds_of(convex), reach_m),
      [&](std::uint32_t i) {
        nearest_m = std::min(nearest_m, distance(convex, shapes.circles()[i]));
      },
      [&](std::uint32_t i) {
        nearest_m = std::min(nearest_m, distance(convex, shapes.edges()[i]));
      });
  return nearest_m;
}

}  // namespace voronaut
