#include "voronaut/environments/polygons/polygon_areas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/envelope.hpp>
#include <boost/geometry/algorithms/intersection.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/algorithms/union.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include "voronaut/environments/generators/placement.h"
#include "voronaut/environments/shapes/polygon_validity.h"

namespace voronaut {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Area = bg::model::polygon<Point, false, false>;  // counter-clockwise, open
using Areas = bg::model::multi_polygon<Area>;
using Box = bg::model::box<Point>;

// Cuts leave slivers of rounding, which no body meets.
constexpr double kSmallestArea_m2 = 1e-9;
constexpr double kSameCoordinate_m = 1e-9;
constexpr double kStraight = 1e-9;
constexpr int kCirclesCorners = 64;

Area::ring_type ring_of(const std::vector<Vec2>& vertices) {
  Area::ring_type ring;
  for (const Vec2& p : vertices) ring.emplace_back(p.x(), p.y());
  return ring;
}

std::vector<Vec2> vertices_of(const Area::ring_type& ring) {
  std::vector<Vec2> vertices;
  for (const Point& p : ring) {
    const Vec2 vertex(p.x(), p.y());
    if (vertices.empty() || vertex != vertices.back()) vertices.push_back(vertex);
  }
  while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  return vertices;
}

Area area_of(const PolygonArea& area) {
  Area polygon;
  polygon.outer() = ring_of(area.outer);
  for (const auto& hole : area.holes) polygon.inners().push_back(ring_of(hole));
  return polygon;
}

Area area_of(const Polygon& polygon) {
  Area area;
  area.outer() = ring_of(polygon.vertices);
  return area;
}

PolygonArea area_of(const Area& polygon) {
  PolygonArea area;
  area.outer = vertices_of(polygon.outer());
  for (const auto& hole : polygon.inners()) area.holes.push_back(vertices_of(hole));
  return area;
}

// Boost leaves the corners of what it united where they lie on a straight edge now.
std::vector<Vec2> without_straight_corners(const std::vector<Vec2>& ring) {
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 before = ring[i] - ring[i > 0 ? i - 1 : ring.size() - 1];
    const Vec2 behind = ring[i + 1 < ring.size() ? i + 1 : 0] - ring[i];
    if (std::abs(cross(before, behind)) > kStraight * before.norm() * behind.norm())
      corners.push_back(ring[i]);
  }
  return corners.size() < 3 ? ring : corners;
}

// In halves, so that each edge goes through as few unions as it must.
Areas united(const std::vector<Area>& areas, std::size_t begin, std::size_t end) {
  if (begin == end) return {};
  if (end - begin == 1) return {areas[begin]};
  const std::size_t middle = begin + (end - begin) / 2;
  Areas both;
  bg::union_(united(areas, begin, middle), united(areas, middle, end), both);
  return both;
}

Areas united(std::vector<Area> areas) {
  std::stable_sort(areas.begin(), areas.end(), [](const Area& a, const Area& b) {
    return a.outer().front().x() < b.outer().front().x();
  });
  return united(areas, 0, areas.size());
}

// Both sides of a cut at x take the same places for the ends of their edges on it.
class CutLine {
 public:
  explicit CutLine(double x) : x_(x) {}

  void snap(Area& area) {
    snap(area.outer());
    for (auto& hole : area.inners()) snap(hole);
  }

 private:
  void snap(Area::ring_type& ring) {
    for (Point& p : ring) {
      if (std::abs(p.x() - x_) > kSameCoordinate_m) continue;
      p.x(x_);
      const auto known = std::find_if(ys_.begin(), ys_.end(), [&p](double y) {
        return std::abs(y - p.y()) <= kSameCoordinate_m;
      });
      if (known != ys_.end())
        p.y(*known);
      else
        ys_.push_back(p.y());
    }
  }

  double x_;
  std::vector<double> ys_;
};

void cut_holes(const Area& area, std::vector<Polygon>& simple) {
  if (std::abs(bg::area(area)) < kSmallestArea_m2) return;
  if (area.inners().empty()) {
    simple.push_back({vertices_of(area.outer())});
    return;
  }
  const Box hole = bg::return_envelope<Box>(area.inners().front());
  const Box whole = bg::return_envelope<Box>(area);
  const double x = (hole.min_corner().x() + hole.max_corner().x()) / 2;
  CutLine line(x);
  const double beyond_m = 1;
  const Point low(whole.min_corner().x() - beyond_m, whole.min_corner().y() - beyond_m);
  const Point high(whole.max_corner().x() + beyond_m, whole.max_corner().y() + beyond_m);
  // Against a box the cut is at x; against another polygon Boost's rescaling moves it by 1e-7 m.
  for (const Box& side : {Box(low, Point(x, high.y())), Box(Point(x, low.y()), high)}) {
    Areas parts;
    bg::intersection(area, side, parts);
    for (Area& part : parts) {
      line.snap(part);
      cut_holes(part, simple);
    }
  }
}

}  // namespace

PolygonArea oriented(PolygonArea area) {
  std::vector<Polygon> rings{{area.outer}};
  for (const auto& hole : area.holes) rings.push_back({hole});
  for (const Polygon& ring : rings)
    if (const std::string problem = validity_problem(ring); !problem.empty())
      throw std::invalid_argument(problem);
  Area polygon = area_of(area);
  bg::correct(polygon);
  std::string reason;
  if (!bg::is_valid(polygon, reason))
    throw std::invalid_argument(reason.substr(0, reason.find(';')));
  return area_of(polygon);
}

std::vector<Polygon> without_holes(const PolygonArea& area) {
  std::vector<Polygon> simple;
  if (area.holes.empty())
    simple.push_back({area.outer});
  else
    cut_holes(area_of(area), simple);
  return simple;
}

std::vector<PolygonArea> united(const std::vector<Polygon>& polygons) {
  std::vector<Area> areas;
  areas.reserve(polygons.size());
  for (const Polygon& polygon : polygons) areas.push_back(area_of(polygon));
  std::vector<PolygonArea> together;
  for (const Area& area : united(std::move(areas))) {
    PolygonArea found = area_of(area);
    found.outer = without_straight_corners(found.outer);
    for (auto& hole : found.holes) hole = without_straight_corners(hole);
    together.push_back(std::move(found));
  }
  return together;
}

Polygon around(const Circle& circle, int corners) {
  const double step_rad = 2 * std::numbers::pi / corners;
  const double reach_m = circle.radius_m / unit_vector(step_rad / 2).x();
  Polygon polygon;
  for (int i = 0; i < corners; ++i)
    polygon.vertices.push_back(circle.center + reach_m * unit_vector((i + 0.5) * step_rad));
  return polygon;
}

double free_share(const Bounds& bounds, const Shapes& shapes) {
  std::vector<Area> areas;
  for (const Polygon& polygon : shapes.polygons) areas.push_back(area_of(polygon));
  for (const Circle& circle : shapes.circles)
    areas.push_back(area_of(around(circle, kCirclesCorners)));
  const Area all = area_of(box(bounds));
  Areas covered;
  bg::intersection(united(std::move(areas)), Areas{all}, covered);
  return std::clamp(1 - bg::area(covered) / bg::area(all), 0.0, 1.0);
}

}  // namespace voronaut
