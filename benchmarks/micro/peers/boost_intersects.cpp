#include "voronaut/benchmarks/micro/peers/boost_intersects.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/geometries.hpp>

namespace voronaut {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Line = bg::model::linestring<Point>;
using Ring = bg::model::polygon<Point, false>;

Point point_of(const Vec2& p) { return {p.x(), p.y()}; }

template <class Use>
bool with_geometry(const std::vector<Vec2>& hull, const Use& use) {
  if (hull.size() == 1) return use(point_of(hull.front()));
  if (hull.size() == 2) return use(Line{point_of(hull[0]), point_of(hull[1])});
  Ring ring;
  for (const Vec2& p : hull) bg::append(ring.outer(), point_of(p));
  bg::append(ring.outer(), point_of(hull.front()));
  return use(ring);
}

}  // namespace

bool boost_intersects(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return with_geometry(a, [&](const auto& first) {
    return with_geometry(b, [&](const auto& second) { return bg::intersects(first, second); });
  });
}

}  // namespace voronaut
