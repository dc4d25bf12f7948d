#include "voronaut/environments/generators/placement.h"

#include <algorithm>
#include <cmath>

#include <sleef.h>

namespace voronaut {
namespace {

// Of the cells of circles: a few posts of some centimetres do not make the cells of all others.
constexpr double kSmallestCell_m = 0.25;

}  // namespace

Vec2 point_in(const Bounds& area, Random& random) {
  const double x = random.uniform(area.min.x(), area.max.x());
  const double y = random.uniform(area.min.y(), area.max.y());
  return {x, y};
}

Vec2 unit_vector(double angle_rad) {
  const Sleef_double_2 sin_cos = Sleef_cinz_sincosd1_u10purec(angle_rad);
  return {sin_cos.y, sin_cos.x};
}

Vec2 turned(const Vec2& v, const Vec2& direction) {
  return {direction.x() * v.x() - direction.y() * v.y(),
          direction.y() * v.x() + direction.x() * v.y()};
}

GeneratedWorld turned(const GeneratedWorld& world, const Vec2& direction) {
  GeneratedWorld result = world;
  for (Circle& circle : result.shapes.circles) circle.center = turned(circle.center, direction);
  for (Segment& segment : result.shapes.segments)
    segment = {turned(segment.a, direction), turned(segment.b, direction)};
  for (Polygon& polygon : result.shapes.polygons)
    for (Vec2& vertex : polygon.vertices) vertex = turned(vertex, direction);
  result.start = turned(world.start, direction);
  result.goal = turned(world.goal, direction);
  const Vec2 first = turned(world.bounds.min, direction);
  result.bounds = {first, first};
  for (const Vec2& corner : {world.bounds.max, Vec2{world.bounds.min.x(), world.bounds.max.y()},
                             Vec2{world.bounds.max.x(), world.bounds.min.y()}}) {
    const Vec2 moved = turned(corner, direction);
    result.bounds = {result.bounds.min.cwiseMin(moved), result.bounds.max.cwiseMax(moved)};
  }
  return result;
}

CirclePlacer::Cell CirclePlacer::cell_of(const Vec2& p) const {
  return {static_cast<std::int64_t>(std::floor(p.x() / cell_m_)),
          static_cast<std::int64_t>(std::floor(p.y() / cell_m_))};
}

void CirclePlacer::list_new_circles() {
  for (; listed_ < circles_.size(); ++listed_) {
    const Circle& circle = circles_[listed_];
    if (listed_ == 0) cell_m_ = std::max(2 * circle.radius_m + mutual_gap_m_, kSmallestCell_m);
    largest_radius_m_ = std::max(largest_radius_m_, circle.radius_m);
    by_cell_[cell_of(circle.center)].push_back(listed_);
  }
}

bool CirclePlacer::fits(const Circle& candidate) {
  const auto apart = [&candidate](const Circle& other, double gap_m) {
    return (candidate.center - other.center).norm() >= candidate.radius_m + other.radius_m + gap_m;
  };
  if (!std::all_of(kept_.begin(), kept_.end(), [&](const Circle& c) { return apart(c, 0); }))
    return false;
  list_new_circles();
  // Grown a little, so that rounding leaves out none that is too close.
  const double reach_m =
      (candidate.radius_m + largest_radius_m_ + mutual_gap_m_) * (1 + 1e-9) + 1e-9;
  const Cell low = cell_of(candidate.center - Vec2::Constant(reach_m));
  const Cell high = cell_of(candidate.center + Vec2::Constant(reach_m));
  for (std::int64_t x = low.first; x <= high.first; ++x) {
    // The cells of a column are neighbours in the map.
    for (auto cell = by_cell_.lower_bound({x, low.second});
         cell != by_cell_.end() && cell->first <= Cell{x, high.second}; ++cell) {
      for (const std::size_t i : cell->second)
        if (!apart(circles_[i], mutual_gap_m_)) return false;
    }
  }
  return true;
}

namespace {

void add_cap(Shapes& shapes, const Vec2& p) {
  const bool there =
      std::any_of(shapes.circles.begin(), shapes.circles.end(), [&p](const Circle& circle) {
        return circle.radius_m == kWallCapRadius && circle.center == p;
      });
  if (!there) shapes.circles.push_back({p, kWallCapRadius});
}

}  // namespace

void add_wall(Shapes& shapes, const Vec2& from, const Vec2& to) {
  if (from != to) shapes.segments.push_back({from, to});
  add_cap(shapes, from);
  add_cap(shapes, to);
}

void add_walls(Shapes& shapes, const std::vector<Vec2>& corners) {
  for (std::size_t i = 1; i < corners.size(); ++i) add_wall(shapes, corners[i - 1], corners[i]);
}

void add_enclosure(Shapes& shapes, const Bounds& area) {
  add_walls(
      shapes,
      {area.min, {area.max.x(), area.min.y()}, area.max, {area.min.x(), area.max.y()}, area.min});
}

void add_wall_with_gap(Shapes& shapes, const Vec2& from, const Vec2& to, double gap_at_m,
                       double gap_m) {
  const Vec2 along = (to - from).normalized();
  add_wall(shapes, from, from + (gap_at_m - kWallCapRadius) * along);
  add_wall(shapes, from + (gap_at_m + gap_m + kWallCapRadius) * along, to);
}

}  // namespace voronaut
