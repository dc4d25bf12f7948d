#include <gtest/gtest.h>

#include "voronaut/environments/formats/dodgedrone.h"
#include "voronaut/environments/formats/ompl_worlds.h"
#include "voronaut/environments/formats/pathbench.h"
#include "voronaut/environments/world.h"
#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

ForeignWorld pathbench(const std::string& text) {
  return read_pathbench(ConfigNode::parse(text, "p.json"), 1);
}

TEST(PathBench, HasItsFirstRowOnTop) {
  const ForeignWorld world = pathbench(
      "{\"type\": \"DenseMap\", \"version\": 1, \"goal\": [1, 2], \"agent\": [0, 0],\n"
      "\"grid\": [[2.0, 1.0, 0.0], [0.0, 0.0, 3.0]]}");
  EXPECT_EQ(*world.start, Vec2(0.5, 1.5));
  EXPECT_EQ(*world.goal, Vec2(2.5, 0.5));
  ASSERT_EQ(world.shapes.polygons.size(), 1U);
  EXPECT_EQ(bounds_of(world.shapes.polygons[0]).min, Vec2(1, 1));
}

TEST(PathBench, IsRefusedWithTheKeyAndTheReason) {
  const auto refused = [](const std::string& text) {
    return error_of<ConfigError>([&] { pathbench(text); });
  };
  EXPECT_EQ(refused("{\"type\": \"SparseMap\", \"grid\": []}"),
            "p.json:1: key 'type': expected one of DenseMap, got the text "
            "'SparseMap'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1], [0]]}"),
            "p.json:1: key 'grid[1]': expected a row of 2 cells, got a list of 1");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 7]]}"),
            "p.json:1: key 'grid[0][1]': expected a number from 0 to 3, got '7'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1]], \"agent\": [0, 2]}"),
            "p.json:1: key 'agent[1]': expected a whole number from 0 to 1, got '2'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"agent\": [0, 0, 0], \"grid\": [[[0, 1], [0, 0]]]}"),
            "p.json:1: key 'grid[0][0]': a map of three dimensions; only those of two are read");
  EXPECT_EQ(refused("{\"type\": \"SparseMap\", \"size\": [4, 4]}"),
            "p.json:1: key 'type': expected one of DenseMap, got the text 'SparseMap'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\",\n\"grid\": [[0, 4]]\n"),
            "p.json:2: not valid JSON: end of map flow not found");
  EXPECT_EQ(refused(""), "p.json:1: the file is empty");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1]"), "p.json:1: a key must be text");
}

TEST(DodgeDrone, CutsSpheresOrTakesThemForColumns) {
  const std::string text =
      "rpg_box01, 1, 2, 1.5, 1, 0, 0, 0, 2, 2, 2\nrpg_box01, 4, 5, 9, 1, 0, 0, 0, 1, 1, 1\n"
      "rpg_box01, 1000.0, 1000.0, 1000.0, 1, 0, 0, 0, 1, 1, 1\n";
  const auto cut = parse_dodgedrone(text, "d.csv", {}).shapes.circles;
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_NEAR(cut[0].radius_m, std::sqrt(0.75), 1e-15);
  ForeignOptions columns;
  columns.cut = BodyCut::columns;
  const auto all = parse_dodgedrone(text, "d.csv", columns).shapes.circles;
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].radius_m, 0.5);
  EXPECT_EQ(error_of<ConfigError>([&] { parse_dodgedrone("a, 1, 2\n", "d.csv", {}); }),
            "d.csv:1: expected 11 fields (prefab, x, y, z, qw, qx, qy, qz, sx, sy, sz), got 3");
  EXPECT_EQ(
      error_of<ConfigError>([&] { parse_dodgedrone("a,1,2,z,1,0,0,0,1,1,1\n", "d.csv", {}); }),
      "d.csv:1: z: expected a number from -100000 to 100000, got 'z'");
  EXPECT_EQ(error_of<ConfigError>([&] { parse_dodgedrone("", "d.csv", {}); }),
            "d.csv:1: the file is empty");
  EXPECT_EQ(
      error_of<ConfigError>([&] { parse_dodgedrone("a,1,2,3,1,0,0,0,2,1,2\n", "d.csv", {}); }),
      "d.csv:1: sx, sy and sz differ: only spheres are read");
  EXPECT_EQ(
      error_of<ConfigError>([&] { parse_dodgedrone("a,1,2,3,1,0,0,0,2,2,1\n", "d.csv", {}); }),
      "d.csv:1: sx, sy and sz differ: only spheres are read");
}

TEST(OmplCircles, AreReadWithTheirQueries) {
  const ForeignWorld world =
      parse_ompl_circles("units: meter\n\tx\ty\tr\n1\t27\t15\t5\n2\t15\t22\t4\n", "c.txt");
  ASSERT_EQ(world.shapes.circles.size(), 2U);
  EXPECT_EQ(world.bounds->min, Vec2(11, 10));
  EXPECT_EQ(world.bounds->max, Vec2(32, 26));
  const auto queries = parse_ompl_circle_queries(
      "0\tstart:\t42.3\t51\n0\tgoal:\t59\t35\n1\tstart:\t7\t4\n1\tgoal:\t10\t14\n", "q.txt");
  ASSERT_EQ(queries.size(), 2U);
  EXPECT_EQ(queries[1].goal, Vec2(10, 14));
  EXPECT_EQ(error_of<ConfigError>([&] { parse_ompl_circles("units: feet\n", "c.txt"); }),
            "c.txt:1: expected the units meter, got 'units: feet'");
  EXPECT_EQ(
      error_of<ConfigError>([&] { parse_ompl_circles("units: meter\n x y r\n1 2 3\n", "c.txt"); }),
      "c.txt:3: expected a number, x, y and r, got '1 2 3'");
  EXPECT_EQ(error_of<ConfigError>(
                [&] { parse_ompl_circle_queries("0 start: 1 2\n1 goal: 1 2\n", "q.txt"); }),
            "q.txt:2: expected '0 goal: x y', got '1 goal: 1 2'");
}

// 3 cells along x, 5 along y; blocked are (0, 3), (2, 0) and (2, 1).
const std::string kOmplHead =
    "discretization(cells): 3 5\nstart(cells): 0 1\nend(cells): 2 4\nenvironment:\n";

std::string ompl_error(const std::string& text) {
  return error_of<ConfigError>([&] { parse_ompl_environment(text, "e.txt", 1); });
}

TEST(OmplEnvironment, IsReadAlongYFirstAsByOmpl) {
  const ForeignWorld world =
      parse_ompl_environment(kOmplHead + "0 0 0 1 0\n0 0 0 0 0\n1 1 0 0 0\n", "e.txt", 2);
  EXPECT_EQ(world.bounds->max, Vec2(6, 10));
  EXPECT_EQ(*world.start, Vec2(1, 3));
  EXPECT_EQ(*world.goal, Vec2(5, 9));
  const World blocked(*world.bounds, world.shapes);
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 5; ++y) {
      const bool expected = (x == 0 && y == 3) || (x == 2 && y <= 1);
      EXPECT_EQ(blocked.clearance_m(world.cells->center(x, y)) < 0, expected) << x << ", " << y;
    }
  }
}

TEST(OmplEnvironment, IsTheSameWhereverItsLinesBreak) {
  const auto seen = [](const std::string& numbers) {
    std::string text;
    for (const Polygon& box :
         parse_ompl_environment(kOmplHead + numbers, "e.txt", 1).shapes.polygons)
      for (const Vec2& p : box.vertices)
        text += number_text(p.x()) + " " + number_text(p.y()) + ";";
    return text;
  };
  const std::string rows = seen("0 0 0 1 0\n0 0 0 0 0\n1 1 0 0 0\n");
  EXPECT_EQ(seen("0 0 0 1 0 0 0 0 0 0 1 1 0 0 0"), rows);
  EXPECT_EQ(seen("0 0 0\n1 0 0\n\n0 0 0\n0 1 1\n0 0 0\n"), rows);
}

TEST(OmplEnvironment, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(ompl_error(kOmplHead + "0 0 0 1 0\n0 0 0 0 0\n1 1 0 0 0\n0\n"),
            "e.txt:8: expected the end of the file, got '0'");
  EXPECT_EQ(ompl_error(kOmplHead + "0 0 0 1 0 0 0 0 0 0\n1 1 0 0 0 7\n"),
            "e.txt:6: expected the end of the file, got '7'");
  EXPECT_EQ(ompl_error(kOmplHead + "0 0 0 1 0\n"), "e.txt:5: the file ends before cell");
  EXPECT_EQ(ompl_error(kOmplHead + "0 0 0 1 2\n"),
            "e.txt:5: cell: expected a whole number from 0 to 1, got '2'");
  EXPECT_EQ(ompl_error("discretization(cells): 3 5\nstart(cells): 3 0\n"),
            "e.txt:2: column: expected a whole number from 0 to 2, got '3'");
  EXPECT_EQ(ompl_error("discretization(cells): 3 5\nstart: 0 0\n"),
            "e.txt:2: expected 'start(cells):', got 'start:'");
  EXPECT_EQ(ompl_error(""), "e.txt:1: the file ends before 'discretization(cells):'");
}

}  // namespace
}  // namespace voronaut
