#include "voronaut/environments/formats/wkt.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_error.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

std::string problem(const std::string& text) {
  return error_of<ConfigError>([&] { parse_wkt_lines(text, "w.wkt"); });
}

TEST(Wkt, IsReadAsShapes) {
  const Shapes polygon = parse_wkt(" POLYGON ((0 0, 4 0, 4 2, 0 0))");
  ASSERT_EQ(polygon.polygons.size(), 1U);
  EXPECT_EQ(polygon.polygons[0].vertices, (std::vector<Vec2>{{0, 0}, {4, 0}, {4, 2}}));
  const Shapes lines = parse_wkt("MULTILINESTRING((0 5,3 5,3 6.5),(1 1,-2 2e-1))");
  ASSERT_EQ(lines.segments.size(), 3U);
  EXPECT_EQ(lines.segments[1].b, Vec2(3, 6.5));
  EXPECT_EQ(lines.segments[2].b, Vec2(-2, 0.2));
  const Shapes all = parse_wkt_lines(
      "MULTIPOLYGON(((0 0,4 0,4 3,0 3,0 0),(1 1,1 2,2 2,2 1,1 1)),((6 0,7 0,6 1,6 0)))\n\n"
      "LINESTRING(0 5,3 5)\r\n",
      "w.wkt");
  EXPECT_EQ(all.segments.size(), 1U);
  EXPECT_LT(clearance_m(all, {0.5, 1.5}), 0);
  EXPECT_EQ(clearance_m(all, {1.5, 1.5}), 0.5);  // in the hole
  EXPECT_LT(clearance_m(all, {6.2, 0.2}), 0);
}

TEST(Wkt, ComesBackAsItWasWritten) {
  Shapes shapes;
  shapes.polygons = {box(Bounds{{0, 0}, {0.1, 3}}), box(Bounds{{0.1, 0}, {2, 1}})};
  shapes.segments = {{{5, 1.0 / 3}, {7, -2}}};
  const std::string text = wkt_of(shapes);
  const Shapes read = parse_wkt_lines(text, "w.wkt");
  ASSERT_EQ(read.polygons.size(), 1U);
  EXPECT_EQ(read.polygons[0].vertices.size(), 6U);
  ASSERT_EQ(read.segments.size(), 1U);
  EXPECT_EQ(read.segments[0].a.y(), 1.0 / 3);
  EXPECT_EQ(wkt_of(read), text);
  EXPECT_EQ(wkt_of({}), "");
}

TEST(Wkt, HasPolygonsForCircles) {
  Shapes shapes;
  shapes.circles = {{{2, 1}, 0.5}};
  const Shapes read = parse_wkt_lines(wkt_of(shapes), "w.wkt");
  ASSERT_EQ(read.polygons.size(), 1U);
  EXPECT_EQ(read.polygons[0].vertices.size(), 64U);
  for (const Vec2& p : read.polygons[0].vertices) EXPECT_NEAR((p - Vec2(2, 1)).norm(), 0.5, 0.001);
}

TEST(Wkt, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(
      problem("\nPOINT(1 2)\n"),
      "w.wkt:2: expected POLYGON, MULTIPOLYGON, LINESTRING or MULTILINESTRING and places, got "
      "'POINT(1 2)'");
  EXPECT_EQ(problem("POLYGON((0 0,1\n"), "w.wkt:1: not well-known text: 'POLYGON((0 0,1'");
  EXPECT_EQ(problem("LINESTRING(0 0,1 x)"), "w.wkt:1: not well-known text: 'LINESTRING(0 0,1 x)'");
  EXPECT_EQ(problem("LINESTRING(0 0,0 0)"), "w.wkt:1: a line repeats a place");
  EXPECT_EQ(problem("LINESTRING(0 0,1e9 0)"),
            "w.wkt:1: expected coordinates from -100000 to 100000");
  EXPECT_NE(problem("POLYGON((0 0,1 1,1 0,0 1,0 0))").find("self-intersections"),
            std::string::npos);
  EXPECT_EQ(problem(""), "w.wkt:1: no shape in the file");
}

}  // namespace
}  // namespace voronaut
