#include <functional>

#include <gtest/gtest.h>

#include "voronaut/environments/formats/dodgedrone.h"
#include "voronaut/environments/formats/ir_sim.h"
#include "voronaut/environments/formats/ompl_worlds.h"
#include "voronaut/environments/formats/pathbench.h"
#include "voronaut/environments/formats/sdf_world.h"

namespace voronaut {
namespace {

std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string sdf_error(const std::string& text) {
  return error_of([&] { parse_sdf_world(text, "w.world"); });
}

std::string sdf(const std::string& models) {
  return "<?xml version=\"1.0\" ?>\n<sdf version='1.6'>\n<world name='default'>\n" + models +
         "</world>\n</sdf>\n";
}

const std::string kCylinder =
    "<model name='unit_cylinder_0'>\n<pose frame=''>-2.25 5 0.5 0 -0 0</pose>\n<link name='link'>"
    "<collision name='c'><geometry><cylinder><radius>0.075</radius><length>1</length></cylinder>"
    "</geometry></collision><visual name='v'><geometry><cylinder><radius>9</radius></cylinder>"
    "</geometry></visual></link>\n</model>\n";

TEST(SdfWorld, GivesTheCylindersAndBoxesThatCollide) {
  const ForeignWorld world = parse_sdf_world(
      sdf("<!-- <model> -->\n" + kCylinder +
          "<model name='ground'><static>1</static><link name='l'><collision name='c'><geometry>"
          "<plane><size>9 9</size></plane></geometry></collision></link></model>\n"
          "<model name='wall'><pose>1 2 0 0 0 1.5707963267948966</pose><link name='l'>"
          "<collision name='c'><geometry><box><size>2 0.5 1</size></box></geometry></collision>"
          "</link></model>\n<include><uri>model://sun</uri></include>\n"
          "<state world_name='default'><model name='unit_cylinder_0'><pose>5 5 5 0 0 0</pose>"
          "</model></state>\n"),
      "w.world");
  ASSERT_EQ(world.shapes.circles.size(), 1U);
  EXPECT_EQ(world.shapes.circles[0].center, Vec2(-2.25, 5));
  EXPECT_EQ(world.shapes.circles[0].radius_m, 0.075);
  ASSERT_EQ(world.shapes.polygons.size(), 1U);
  const Bounds wall = bounds_of(world.shapes.polygons[0]);
  EXPECT_NEAR((wall.min - Vec2(0.75, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((wall.max - Vec2(1.25, 3)).norm(), 0, 1e-12);
  EXPECT_FALSE(world.bounds);
}

TEST(SdfWorld, IsRefusedWithTheLineAndTheReason) {
  EXPECT_EQ(sdf_error(""), "w.world:1: no <world> in <sdf>");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n"), "w.world:2: the file ends inside <world>");
  EXPECT_EQ(sdf_error("<sdf>\n<world>\n</sdf>"), "w.world:3: </sdf> ends what is not open");
  EXPECT_EQ(sdf_error("<sdf>\n<world"), "w.world:2: a tag does not end");
  EXPECT_EQ(sdf_error("<sdf>\n<!-- world"), "w.world:2: a comment or declaration does not end");
  EXPECT_EQ(sdf_error(sdf("<model>\n<pose>1 2 x 0 0 0</pose></model>")),
            "w.world:5: pose: expected a number, got 'x'");
  EXPECT_EQ(sdf_error(sdf("<model><pose>1 2 3</pose></model>")),
            "w.world:4: pose: expected 6 numbers, got 3");
  EXPECT_EQ(sdf_error(sdf("<model><pose>1 2 3 0.5 0 0</pose></model>")),
            "w.world:4: a tilted model is not supported");
  EXPECT_EQ(sdf_error(sdf("<model><link><pose>1 0 0 0 0 0</pose></link></model>")),
            "w.world:4: a pose inside a model is not supported");
  EXPECT_EQ(sdf_error(sdf("<model><link><collision><geometry><cylinder><radius>0</radius>"
                          "</cylinder></geometry></collision></link></model>")),
            "w.world:4: expected a size from 0.001 to 1000, got 0");
}

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
  const auto refused = [](const std::string& text) { return error_of([&] { pathbench(text); }); };
  EXPECT_EQ(refused("{\"type\": \"SparseMap\", \"grid\": []}"),
            "p.json:1: key 'type': expected one of DenseMap, got the text "
            "'SparseMap'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1], [0]]}"),
            "p.json:1: key 'grid[1]': expected a row of 2 cells, got a list of 1");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 7]]}"),
            "p.json:1: key 'grid[0][1]': expected a number from 0 to 3, got '7'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1]], \"agent\": [0, 2]}"),
            "p.json:1: key 'agent[1]': expected a whole number from 0 to 1, got '2'");
  EXPECT_EQ(refused("{\"type\": \"DenseMap\", \"grid\": [[0, 1]"), "p.json:1: a key must be text");
}

ForeignWorld ir_sim(const std::string& text) {
  return read_ir_sim(
      ConfigNode::parse("world: {height: 10, width: 20, offset: [1, 2]}\n" + text, "w.yaml"));
}

TEST(IrSim, GivesTheShapesAtTheirStates) {
  const ForeignWorld world = ir_sim(
      "robot:\n  - {kinematics: {name: diff}, state: [1, 2, 0], goal: [9, 8, 0]}\n"
      "obstacle:\n  - {shape: {name: circle, radius: 1, center: [1, 0]}, state: [5, 5, "
      "1.5707963267948966]}\n"
      "  - {shape: {name: rectangle, length: 2, width: 1}, state: [6, 5, 0]}\n"
      "  - {shape: {name: linestring, vertices: [[5, 5], [4, 0], [1, 6]]}}\n"
      "  - {shape: {name: polygon, vertices: [[0, 0], [1, 0], [0, 1]]}, state: [1, 1]}\n"
      "  - {number: 2, distribution: {name: manual}, state: [[1, 2], [3, 4], [5, 6]], shape: "
      "[{name: circle, radius: 0.5}]}\n");
  EXPECT_EQ(world.bounds->min, Vec2(1, 2));
  EXPECT_EQ(world.bounds->max, Vec2(21, 12));
  EXPECT_EQ(*world.start, Vec2(1, 2));
  EXPECT_EQ(*world.goal, Vec2(9, 8));
  ASSERT_EQ(world.shapes.circles.size(), 3U);
  EXPECT_NEAR((world.shapes.circles[0].center - Vec2(5, 6)).norm(), 0, 1e-12);
  EXPECT_EQ(world.shapes.circles[2].center, Vec2(3, 4));
  EXPECT_EQ(world.shapes.segments.size(), 2U);
  ASSERT_EQ(world.shapes.polygons.size(), 2U);
  EXPECT_EQ(bounds_of(world.shapes.polygons[0]).min, Vec2(5, 4.5));
  EXPECT_EQ(world.shapes.polygons[1].vertices[1], Vec2(2, 1));
}

TEST(IrSim, IsRefusedWhereItWouldDrawAtRandom) {
  const auto refused = [](const std::string& text) { return error_of([&] { ir_sim(text); }); };
  EXPECT_EQ(refused("obstacle:\n  - {number: 9, distribution: {name: random}, shape: {name: "
                    "circle, radius: 1}}\n"),
            "w.yaml:3: key 'obstacle[0].distribution': obstacles placed at random are no world to "
            "read");
  EXPECT_EQ(refused("obstacle:\n  - {shape: {name: polygon, random_shape: true}}\n"),
            "w.yaml:3: key 'obstacle[0].shape': without vertices: a random shape has no world to "
            "read");
  EXPECT_EQ(refused("obstacle:\n  - {shape: {name: sphere}}\n"),
            "w.yaml:3: key 'obstacle[0].shape.name': expected one of circle, rectangle, polygon, "
            "linestring, got 'sphere'");
}

TEST(DodgeDrone, CutsSpheresOrTakesThemForColumns) {
  const std::string text =
      "rpg_box01, 1, 2, 1.5, 1, 0, 0, 0, 2, 2, 2\nrpg_box01, 4, 5, 9, 1, 0, 0, 0, 1, 1, 1\n"
      "rpg_box01, 1000.0, 1000.0, 1000.0, 1, 0, 0, 0, 1, 1, 1\n";
  const auto cut = parse_dodgedrone(text, "d.csv", {}).shapes.circles;
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_NEAR(cut[0].radius_m, std::sqrt(0.75), 1e-15);
  ForeignOptions columns;
  columns.cut = SphereCut::columns;
  const auto all = parse_dodgedrone(text, "d.csv", columns).shapes.circles;
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].radius_m, 0.5);
  EXPECT_EQ(error_of([&] { parse_dodgedrone("a, 1, 2\n", "d.csv", {}); }),
            "d.csv:1: expected 11 fields (prefab, x, y, z, qw, qx, qy, qz, sx, sy, sz), got 3");
  EXPECT_EQ(error_of([&] { parse_dodgedrone("a,1,2,z,1,0,0,0,1,1,1\n", "d.csv", {}); }),
            "d.csv:1: z: expected a number from -100000 to 100000, got 'z'");
  EXPECT_EQ(error_of([&] { parse_dodgedrone("", "d.csv", {}); }), "d.csv: the file is empty");
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
  EXPECT_EQ(error_of([&] { parse_ompl_circles("units: feet\n", "c.txt"); }),
            "c.txt:1: expected the units meter, got 'units: feet'");
  EXPECT_EQ(error_of([&] { parse_ompl_circles("units: meter\n x y r\n1 2 3\n", "c.txt"); }),
            "c.txt:3: expected a number, x, y and r, got '1 2 3'");
  EXPECT_EQ(error_of([&] { parse_ompl_circle_queries("0 start: 1 2\n1 goal: 1 2\n", "q.txt"); }),
            "q.txt:2: expected '0 goal: x y', got '1 goal: 1 2'");
}

TEST(OmplEnvironment, HasItsFirstRowOnTop) {
  const std::string text =
      "discretization(cells): 3 2\nstart(cells): 0 0\nend(cells): 1 2\nenvironment:\n0 1 0\n0 0 "
      "0\n";
  const ForeignWorld world = parse_ompl_environment(text, "e.txt", 1);
  EXPECT_EQ(*world.start, Vec2(0.5, 1.5));
  EXPECT_EQ(*world.goal, Vec2(2.5, 0.5));
  ASSERT_EQ(world.shapes.polygons.size(), 1U);
  EXPECT_EQ(bounds_of(world.shapes.polygons[0]).min, Vec2(1, 1));
  EXPECT_EQ(error_of([&] { parse_ompl_environment(text + "0 0 0\n", "e.txt", 1); }),
            "e.txt:7: expected the end of the file, got '0 0 0'");
  EXPECT_EQ(error_of([&] {
              parse_ompl_environment(
                  "discretization(cells): 3 2\nstart(cells): 0 0\nend(cells): 1 2\nenvironment:\n",
                  "e.txt", 1);
            }),
            "e.txt:4: the file ends after 0 of 2 rows");
}

}  // namespace
}  // namespace voronaut
