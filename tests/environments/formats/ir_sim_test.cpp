#include "voronaut/environments/formats/ir_sim.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

ForeignWorld read(const std::string& text) {
  return read_ir_sim(ConfigNode::parse(text, "w.yaml"));
}

// Below its world, in line 1.
ForeignWorld ir_sim(const std::string& text) {
  return read("world: {height: 10, width: 20, offset: [1, 2]}\n" + text);
}

std::string error_of(const std::string& text) {
  try {
    ir_sim(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
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

TEST(IrSim, HasTenMetresWhereNoSizeIsGiven) {
  EXPECT_EQ(read("world: {step_time: 0.1, offset: [1, 2]}\n").bounds->max, Vec2(11, 12));
  EXPECT_EQ(read("robot: {state: [1, 1]}\n").bounds->max, Vec2(10, 10));
}

TEST(IrSim, LeavesOutWhatNothingCollidesWith) {
  const std::string circle = "shape: {name: circle, radius: 1}";
  EXPECT_TRUE(ir_sim("obstacle: {" + circle + ", unobstructed: True}\n").shapes.empty());
  EXPECT_FALSE(ir_sim("obstacle: {" + circle + ", unobstructed: False}\n").shapes.empty());
  const Shapes some = ir_sim("obstacle: {number: 3, unobstructed: [false, true], " + circle +
                             ", state: [[1, 1], [2, 2], [3, 3]]}\n")
                          .shapes;
  ASSERT_EQ(some.circles.size(), 1U);
  EXPECT_EQ(some.circles[0].center, Vec2(1, 1));
  EXPECT_EQ(error_of("obstacle: {" + circle + ", unobstructed: 2}\n"),
            "w.yaml:2: key 'obstacle.unobstructed': expected true or false, got '2'");
}

TEST(IrSim, TakesAPolygonThatRepeatsItsFirstVertexForClosed) {
  const Shapes shapes =
      ir_sim("obstacle: {shape: {name: polygon, vertices: [[0, 0], [1, 0], [0, 1], [0, 0]]}}\n")
          .shapes;
  ASSERT_EQ(shapes.polygons.size(), 1U);
  EXPECT_EQ(shapes.polygons[0].vertices.size(), 3U);
}

TEST(IrSim, IsRefusedWhereItWouldPlaceOrShapeByItself) {
  EXPECT_EQ(error_of("obstacle:\n  - {number: 9, distribution: {name: random}, shape: {name: "
                     "circle, radius: 1}}\n"),
            "w.yaml:3: key 'obstacle[0].distribution': obstacles that IR-SIM places itself, at "
            "random or in a circle, are not read: give manual and their states");
  EXPECT_EQ(error_of("obstacle:\n  - {number: 9, shape: {name: polygon, random_shape: True, "
                     "vertices: [[0, 0], [1, 0], [0, 1]]}}\n"),
            "w.yaml:3: key 'obstacle[0].shape.random_shape': a shape drawn at random is not read");
}

TEST(IrSim, IsRefusedWhereAnObstacleWouldBeLostOrMoved) {
  const auto refused = [](const std::string& world) {
    try {
      read(world);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(refused("world: {height: 9, width: 9,\n  obstacle_map: 'cave.png', mdownsample: 2}\n"),
            "w.yaml:2: key 'world.obstacle_map': an obstacle map is not read");
  EXPECT_EQ(refused("world: {ofset: [1, 1]}\n").substr(0, 46),
            "w.yaml:1: key 'world.ofset': unknown key (allo");
  EXPECT_EQ(error_of("obstacles: []\n"),
            "w.yaml:2: key 'obstacles': unknown key (allowed: world, robot, obstacle, gui; did you "
            "mean 'obstacle'?)");
  EXPECT_EQ(error_of("obstacle: {shape: {name: rectangle, length: 1, width: 1, wheelbase: 3}}\n"),
            "w.yaml:2: key 'obstacle.shape.wheelbase': unknown key (allowed: name, radius, center, "
            "length, width, vertices, random_shape, is_convex)");
  EXPECT_EQ(error_of("obstacle: {shap: {name: circle, radius: 1}}\n").substr(0, 43),
            "w.yaml:2: key 'obstacle.shap': unknown key ");
  EXPECT_EQ(error_of("obstacle:\n  - {shape: {name: sphere}}\n"),
            "w.yaml:3: key 'obstacle[0].shape.name': expected one of circle, rectangle, polygon, "
            "linestring, got 'sphere'");
}

}  // namespace
}  // namespace voronaut
