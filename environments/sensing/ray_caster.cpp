#include "voronaut/environments/sensing/ray_caster.h"

#include <cmath>
#include <numbers>

namespace voronaut {
namespace {

constexpr double kMiss = std::numeric_limits<double>::infinity();

// Range along the unit vector d from the origin to a circle around c that does not hold the origin.
inline double hit_circle(const Vec2& d, const Vec2& c, double radius_sq) {
  const double across = cross(d, c);
  const double half_chord_sq = radius_sq - across * across;
  const double ahead = d.dot(c);
  if (half_chord_sq < 0 || ahead < 0) return kMiss;
  return ahead - std::sqrt(half_chord_sq);
}

// Range along d to a wall whose end a is not to the left of its end b, seen from the origin, which
// is not on the wall. Interpolates between the ends: bounded however edge-on the wall is seen.
inline double hit_wall(const Vec2& d, const Vec2& a, const Vec2& b) {
  const double right = cross(a, d);
  const double left = cross(d, b);
  if (right < 0 || left < 0) return kMiss;
  const double width = right + left;
  const double a_ahead = d.dot(a);
  const double b_ahead = d.dot(b);
  if (width > 0) return a_ahead + (b_ahead - a_ahead) * (right / width);
  return a_ahead < 0 ? kMiss : std::min(a_ahead, b_ahead);
}

inline bool holds_origin(const Vec2& a, const Vec2& b) { return cross(a, b) == 0 && a.dot(b) <= 0; }

// Beams in the order of their bearing, counted from the first one: a binary search by cross
// products, told apart at half a turn from the first beam.
class BeamOrder {
 public:
  explicit BeamOrder(const BeamFan& fan)
      : beams_(fan.direction_sensor.data()), count_(fan.direction_sensor.size()), half_(count_) {
    const double spread_rad = fan.bearing_step_rad * static_cast<double>(count_ - 1);
    narrow_ = spread_rad < std::numbers::pi - 1e-6;
    if (narrow_) return;
    half_ = static_cast<std::size_t>(std::numbers::pi / fan.bearing_step_rad);
    while (half_ > 1 && cross(first(), beams_[half_ - 1]) < 0) --half_;
    while (half_ < count_ && cross(first(), beams_[half_]) >= 0) ++half_;
  }

  // Less than half a turn: a beam is between the first and the last if it is left of the one and
  // right of the other.
  bool narrow() const { return narrow_; }
  const Vec2& first() const { return beams_[0]; }
  const Vec2& last() const { return beams_[count_ - 1]; }

  // Calls hit(beam) for the beams from the direction `right` counter-clockwise, round the circle if
  // need be, as long as it returns true. The beam before may have been told right of it by
  // rounding and is asked too, as is the one after a miss at the first.
  template <class Hit>
  void sweep_from(const Vec2& right, Hit&& hit) const {
    std::size_t start = first_not_right_of(right);
    if (start == count_) start = 0;
    hit((start == 0 ? count_ : start) - 1);
    hit(start);
    std::size_t beam = start + 1;
    for (; beam < count_; ++beam) {
      if (!hit(beam)) return;
    }
    for (beam = 0; beam < start && hit(beam);) ++beam;
  }

 private:
  std::size_t first_not_right_of(const Vec2& v) const {
    const bool near_half = cross(first(), v) >= 0;
    std::size_t low = near_half ? 0 : half_;
    std::size_t high = near_half ? half_ : count_;
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (cross(beams_[middle], v) > 0) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  const Vec2* beams_;
  std::size_t count_;
  std::size_t half_;  // first beam at half a turn or more from the first
  bool narrow_ = false;
};

Vec2 into_frame(const Vec2& heading, const Vec2& v) { return {heading.dot(v), cross(heading, v)}; }

// One scan under way. Shapes are turned into the frame of the sensor, so that beams need not be.
class FanSweep {
 public:
  FanSweep(const Pose2& sensor, const BeamFan& fan, double max_range_m, std::span<double> range_m)
      : sensor_(sensor),
        beams_(fan.direction_sensor.data()),
        order_(fan),
        max_range_m_(max_range_m),
        range_m_(range_m) {}

  // The sensor is on or in a shape.
  bool blind() const { return blind_; }

  // What the beams can reach, in the world frame.
  Bounds area() const {
    const Vec2 reach = Vec2::Constant(max_range_m_);
    if (!order_.narrow()) return {sensor_.p_world - reach, sensor_.p_world + reach};
    const Vec2 first = in_world(order_.first());
    const Vec2 last = in_world(order_.last());
    Vec2 low = first.cwiseMin(last).cwiseMin(Vec2::Zero());
    Vec2 high = first.cwiseMax(last).cwiseMax(Vec2::Zero());
    const auto between = [&](const Vec2& axis) {
      return cross(first, axis) >= 0 && cross(axis, last) >= 0;
    };
    if (between({1, 0})) high.x() = 1;
    if (between({0, 1})) high.y() = 1;
    if (between({-1, 0})) low.x() = -1;
    if (between({0, -1})) low.y() = -1;
    return {sensor_.p_world + max_range_m_ * low, sensor_.p_world + max_range_m_ * high};
  }

  void circle(const Circle& circle) {
    const Vec2 c = into_frame(sensor_.heading, circle.center - sensor_.p_world);
    const double radius_m = circle.radius_m;
    const double radius_sq = radius_m * radius_m;
    const double distance_sq = c.squaredNorm();
    if (distance_sq <= radius_sq) blind_ = true;
    const double reach_m = max_range_m_ + radius_m;
    if (blind_ || distance_sq > reach_m * reach_m) return;
    if (order_.narrow() && (cross(order_.first(), c) < -radius_m - kSlackM ||
                            cross(order_.last(), c) > radius_m + kSlackM)) {
      return;
    }
    // c turned clockwise by the half angle of the circle.
    const double tangent_m = std::sqrt(distance_sq - radius_sq);
    const Vec2 right = tangent_m * c - radius_m * left_of(c);
    order_.sweep_from(right, [&](std::size_t beam) {
      return keep(beam, hit_circle(beams_[beam], c, radius_sq));
    });
  }

  void wall(const Segment& wall) {
    Vec2 a = into_frame(sensor_.heading, wall.a - sensor_.p_world);
    Vec2 b = into_frame(sensor_.heading, wall.b - sensor_.p_world);
    double turn = cross(a, b);
    if (holds_origin(a, b)) blind_ = true;
    if (blind_ || turn * turn > max_range_m_ * max_range_m_ * (b - a).squaredNorm()) return;
    if (turn < 0) std::swap(a, b);
    if (order_.narrow()) {
      const bool right = cross(order_.first(), a) < 0 && cross(order_.first(), b) < 0;
      const bool left = cross(order_.last(), a) > 0 && cross(order_.last(), b) > 0;
      if (right || left) return;
    }
    order_.sweep_from(a,
                      [&](std::size_t beam) { return keep(beam, hit_wall(beams_[beam], a, b)); });
  }

 private:
  // Wider than the rounding of a distance, so that no tangent beam is culled.
  static constexpr double kSlackM = 1e-9;

  Vec2 in_world(const Vec2& d) const {
    const Vec2& h = sensor_.heading;
    return {h.x() * d.x() - h.y() * d.y(), h.y() * d.x() + h.x() * d.y()};
  }

  bool keep(std::size_t beam, double hit_m) {
    range_m_[beam] = std::min(range_m_[beam], hit_m);
    return hit_m != kMiss;
  }

  const Pose2& sensor_;
  const Vec2* beams_;
  BeamOrder order_;
  double max_range_m_;
  std::span<double> range_m_;
  bool blind_ = false;
};

}  // namespace

double cast_ray(const ShapeIndex& shapes, const Vec2& origin, const Vec2& direction,
                double max_range_m) {
  if (shapes.is_inside_polygon(origin)) return 0;
  double nearest_m = max_range_m;
  shapes.walk(
      origin, direction, max_range_m,
      [&](std::uint32_t i) {
        const Circle& circle = shapes.circles()[i];
        const Vec2 c = circle.center - origin;
        const double radius_sq = circle.radius_m * circle.radius_m;
        nearest_m = std::min(
            nearest_m, c.squaredNorm() <= radius_sq ? 0 : hit_circle(direction, c, radius_sq));
      },
      [&](std::uint32_t i) {
        const Vec2 a = shapes.edges()[i].a - origin;
        const Vec2 b = shapes.edges()[i].b - origin;
        const bool swap = cross(a, b) < 0;
        nearest_m = std::min(nearest_m, holds_origin(a, b) ? 0
                                        : swap             ? hit_wall(direction, b, a)
                                                           : hit_wall(direction, a, b));
      },
      [&](double leave_m) { return nearest_m <= leave_m; });
  return nearest_m;
}

void cast_fan(const ShapeIndex& shapes, const Pose2& sensor, const BeamFan& fan, double max_range_m,
              std::span<double> range_m) {
  std::fill(range_m.begin(), range_m.end(), max_range_m);
  FanSweep sweep(sensor, fan, max_range_m, range_m);
  if (!shapes.is_inside_polygon(sensor.p_world)) {
    shapes.visit(
        sweep.area(), [&](std::uint32_t i) { sweep.circle(shapes.circles()[i]); },
        [&](std::uint32_t i) { sweep.wall(shapes.edges()[i]); });
    if (!sweep.blind()) return;
  }
  std::fill(range_m.begin(), range_m.end(), 0.0);
}

}  // namespace voronaut
