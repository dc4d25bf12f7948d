#pragma once

#include <string>

#include "voronaut/environments/shapes/shapes.h"

// Well-known text (OGC 06-103r4), metres.
namespace voronaut {

// The shapes of one POLYGON, MULTIPOLYGON, LINESTRING or MULTILINESTRING: polygons are solid, one
// with holes comes as several that share edges (polygon_areas.h); lines are walls without
// thickness. Throws std::invalid_argument, in one line, for what is no such text, and for what is
// not valid with the reason.
Shapes parse_wkt(const std::string& text);

// The shapes of a text of one such geometry a line. Throws ConfigError with the line.
Shapes parse_wkt_lines(const std::string& text, const std::string& file);

// One line for all solid shapes, a MULTIPOLYGON of what they cover together, in which circles have
// 64 corners, and one LINESTRING for each wall. Numbers read back as the same.
std::string wkt_of(const Shapes& shapes);

}  // namespace voronaut
