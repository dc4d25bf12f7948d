#include "voronaut/environments/shortest_path/sight_cone.h"

#include <cmath>

namespace voronaut {
namespace {

// Along the axis of a cone and to the left of it.
struct ConeFrame {
  const SightCone& cone;

  Vec2 operator()(const Vec2& p) const {
    const Vec2 from = p - cone.apex;
    return {cone.axis.dot(from), cross(cone.axis, from)};
  }
  double half_width_m(double ahead_m) const {
    return cone.half_width_m + ahead_m * cone.half_slope;
  }
};

}  // namespace

double sight_range_m(const ShapeIndex& shapes, const SightCone& cone, double radius_m,
                     double range_m) {
  const ConeFrame frame{cone};
  double blocked_m = std::numeric_limits<double>::infinity();
  shapes.walk(
      cone.apex, cone.axis, range_m,
      [&](std::uint32_t i) {
        // Every line passes the centre closer than the disc may come.
        const Vec2 c = frame(shapes.circles()[i].center);
        const double reach_m = shapes.circles()[i].radius_m + radius_m;
        if (c.x() >= cone.half_width_m && std::abs(c.y()) + frame.half_width_m(c.x()) < reach_m) {
          blocked_m = std::min(blocked_m, c.x());
        }
      },
      [&](std::uint32_t i) {
        // Every line passes between the ends, or closer to one than the disc may come.
        Vec2 right = frame(shapes.edges()[i].a);
        Vec2 left = frame(shapes.edges()[i].b);
        if (right.y() > left.y()) std::swap(right, left);
        if (std::min(left.x(), right.x()) >= cone.half_width_m &&
            left.y() + radius_m > frame.half_width_m(left.x()) &&
            right.y() - radius_m < -frame.half_width_m(right.x())) {
          blocked_m = std::min(blocked_m, std::max(left.x(), right.x()));
        }
      },
      [&](double leave_m) { return blocked_m <= leave_m; });
  return blocked_m;
}

}  // namespace voronaut
