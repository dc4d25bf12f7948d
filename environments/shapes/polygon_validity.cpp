#include "voronaut/environments/shapes/polygon_validity.h"

#include <boost/geometry/algorithms/correct.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>

namespace voronaut {

namespace bg = boost::geometry;

std::string validity_problem(const Polygon& polygon) {
  bg::model::ring<bg::model::d2::point_xy<double>, false, false> ring;
  for (const Vec2& p : polygon.vertices) ring.emplace_back(p.x(), p.y());
  bg::correct(ring);
  std::string reason;
  if (bg::is_valid(ring, reason)) return "";
  // "Geometry has spikes. A spike point ...; method: ...": the rest is about its algorithm.
  constexpr std::string_view kSubject = "Geometry ";
  if (reason.starts_with(kSubject)) reason.erase(0, kSubject.size());
  return reason.substr(0, reason.find(';'));
}

}  // namespace voronaut
