#include "voronaut/environments/formats/wkt.h"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/csv_table.h"
#include "voronaut/environments/formats/text_lines.h"
#include "voronaut/environments/polygons/polygon_areas.h"

namespace voronaut {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Line = bg::model::linestring<Point>;
using Area = bg::model::polygon<Point>;

constexpr int kCirclesCorners = 64;

template <class Geometry>
Geometry read(const std::string& text) {
  Geometry geometry;
  try {
    bg::read_wkt(text, geometry);
  } catch (const std::exception&) {
    throw std::invalid_argument("not well-known text: " + in_quotes(text));
  }
  return geometry;
}

Vec2 place(const Point& p) {
  if (!(std::abs(p.x()) <= kFarthestCoordinate && std::abs(p.y()) <= kFarthestCoordinate))
    throw std::invalid_argument("expected coordinates from " + number_text(-kFarthestCoordinate) +
                                " to " + number_text(kFarthestCoordinate));
  return {p.x(), p.y()};
}

// Rings end where they began.
std::vector<Vec2> ring(const Area::ring_type& points) {
  std::vector<Vec2> vertices;
  for (const Point& p : points) vertices.push_back(place(p));
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  return vertices;
}

void add(const Area& polygon, Shapes& shapes) {
  PolygonArea area;
  area.outer = ring(polygon.outer());
  for (const auto& hole : polygon.inners()) area.holes.push_back(ring(hole));
  for (Polygon& simple : without_holes(oriented(std::move(area))))
    shapes.polygons.push_back(std::move(simple));
}

void add(const Line& line, Shapes& shapes) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Segment segment{place(line[i - 1]), place(line[i])};
    if (segment.a == segment.b) throw std::invalid_argument("a line repeats a place");
    shapes.segments.push_back(segment);
  }
}

std::string ring_text(const std::vector<Vec2>& vertices) {
  std::string text = "(";
  for (const Vec2& p : vertices) text += number_text(p.x()) + " " + number_text(p.y()) + ",";
  return text + number_text(vertices.front().x()) + " " + number_text(vertices.front().y()) + ")";
}

}  // namespace

Shapes parse_wkt(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::string_view begin = std::string_view(text).substr(std::min(first, text.size()));
  Shapes shapes;
  if (begin.starts_with("POLYGON")) {
    add(read<Area>(text), shapes);
  } else if (begin.starts_with("MULTIPOLYGON")) {
    for (const Area& area : read<bg::model::multi_polygon<Area>>(text)) add(area, shapes);
  } else if (begin.starts_with("LINESTRING")) {
    add(read<Line>(text), shapes);
  } else if (begin.starts_with("MULTILINESTRING")) {
    for (const Line& line : read<bg::model::multi_linestring<Line>>(text)) add(line, shapes);
  } else {
    throw std::invalid_argument(
        "expected POLYGON, MULTIPOLYGON, LINESTRING or MULTILINESTRING and places, got " +
        in_quotes(text));
  }
  return shapes;
}

Shapes parse_wkt_lines(const std::string& text, const std::string& file) {
  TextLines lines(text, file);
  Shapes all;
  while (lines.next()) {
    if (lines.words().empty()) continue;
    try {
      const Shapes shapes = parse_wkt(std::string(lines.line()));
      all.polygons.insert(all.polygons.end(), shapes.polygons.begin(), shapes.polygons.end());
      all.segments.insert(all.segments.end(), shapes.segments.begin(), shapes.segments.end());
    } catch (const std::invalid_argument& error) {
      throw lines.error(error.what());
    }
  }
  if (all.empty()) throw lines.error("no shape in the file");
  return all;
}

std::string wkt_of(const Shapes& shapes) {
  std::vector<Polygon> solids = shapes.polygons;
  for (const Circle& circle : shapes.circles) solids.push_back(around(circle, kCirclesCorners));
  std::string text;
  for (const PolygonArea& area : united(solids)) {
    text += text.empty() ? "MULTIPOLYGON((" : ",(";
    text += ring_text(area.outer);
    for (const auto& hole : area.holes) text += "," + ring_text(hole);
    text += ")";
  }
  if (!text.empty()) text += ")\n";
  for (const Segment& s : shapes.segments)
    text += "LINESTRING(" + number_text(s.a.x()) + " " + number_text(s.a.y()) + "," +
            number_text(s.b.x()) + " " + number_text(s.b.y()) + ")\n";
  return text;
}

}  // namespace voronaut
