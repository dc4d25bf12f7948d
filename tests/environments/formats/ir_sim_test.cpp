#include "voronaut/environments/formats/ir_sim.h"

#include <gtest/gtest.h>

#include "voronaut/tests/support/error_of.h"

namespace voronaut {
namespace {

ForeignWorld read(const std::string& text) {
  return read_ir_sim(ConfigNode::parse(text, "w.yaml"));
}

// Below its world, in line 1.
ForeignWorld ir_sim(const std::string& text) {
  return read("world: {height: 10, width: 20, offset: [1, 2]}\n" + text);
}

std::string error_in(const std::string& text) {
  return error_of<ConfigError>([&] { ir_sim(text); });
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

TEST(IrSim, TellsItsRobotsBodyWhereThatIsOneDiscOrOneConvexPolygon) {
  const auto body = [](const std::string& shape) {
    return ir_sim("robot: {state: [1, 2, 1.5], shape: " + shape + "}\n").robot;
  };
  EXPECT_EQ(ir_sim("robot: {state: [1, 2]}\n").robot->radius_m, 0.2);
  EXPECT_EQ(body("{name: circle, radius: 0.3}")->radius_m, 0.3);
  const auto rectangle = body("{name: rectangle, length: 0.5, width: 0.2}");
  ASSERT_TRUE(rectangle);
  EXPECT_EQ(rectangle->corners_body,
            (std::vector<Vec2>{{-0.25, -0.1}, {0.25, -0.1}, {0.25, 0.1}, {-0.25, 0.1}}));
  EXPECT_EQ(body("{name: polygon, vertices: [[-1, -1], [2, 0], [-1, 1]]}")->corners_body.size(),
            3U);
  for (const char* untold :
       {"{name: circle, radius: 0.3, center: [0.1, 0]}",
        "{name: rectangle, length: 4.6, width: 1.6, wheelbase: 3}",
        "{name: polygon, vertices: [[1, -1], [2, 0], [1, 1]]}",
        "{name: linestring, vertices: [[0, 0], [1, 0]]}", "{name: polygon, random_shape: true}"})
    EXPECT_FALSE(body(untold)) << untold;
  EXPECT_FALSE(ir_sim("obstacle: {state: [1, 2]}\n").robot) << "a file without a robot";
}

TEST(IrSim, HasTenMetresWhereNoSizeIsGiven) {
  EXPECT_EQ(read("world: {step_time: 0.1, offset: [1, 2]}\n").bounds->max, Vec2(11, 12));
  EXPECT_EQ(read("robot: {state: [1, 1]}\n").bounds->max, Vec2(10, 10));
}

TEST(IrSim, PutsWhatHasNoStateWhereIrSimDoes) {
  const ForeignWorld world = ir_sim(
      "robot: {kinematics: {name: diff}}\nobstacle:\n"
      "  - {shape: {name: polygon, vertices: [[2, 1], [3, 1], [3, 4], [2, 4]]}}\n"
      "  - {shape: {name: rectangle}, state: [8, 5]}\n  - {shape: {name: circle}}\n"
      "  - {state: [6, 7]}\n");
  EXPECT_EQ(*world.start, Vec2(1, 1));
  EXPECT_EQ(*world.goal, Vec2(1, 9));
  ASSERT_EQ(world.shapes.polygons.size(), 2U);
  EXPECT_EQ(bounds_of(world.shapes.polygons[0]).min, Vec2(3, 2));
  EXPECT_EQ(bounds_of(world.shapes.polygons[0]).max, Vec2(4, 5));
  EXPECT_EQ(bounds_of(world.shapes.polygons[1]).min, Vec2(7.5, 4.5));
  EXPECT_EQ(bounds_of(world.shapes.polygons[1]).max, Vec2(8.5, 5.5));
  ASSERT_EQ(world.shapes.circles.size(), 2U);
  EXPECT_EQ(world.shapes.circles[0].center, Vec2(1, 1));
  EXPECT_EQ(world.shapes.circles[0].radius_m, 0.2);
  EXPECT_EQ(world.shapes.circles[1].center, Vec2(6, 7));
}

TEST(IrSim, RepeatsTheLastOfAShorterList) {
  const Shapes shapes =
      ir_sim(
          "obstacle: {number: 3, state: [[4, 1, 0], [7, 2, 0]], shape: [{name: circle, radius: "
          "0.5}, {name: circle, radius: 0.1}]}\n")
          .shapes;
  ASSERT_EQ(shapes.circles.size(), 3U);
  EXPECT_EQ(shapes.circles[1].center, Vec2(7, 2));
  EXPECT_EQ(shapes.circles[2].center, Vec2(7, 2));
  EXPECT_EQ(shapes.circles[2].radius_m, 0.1);
  const Shapes walls =
      ir_sim(
          "obstacle: {number: 2, state: [3, 4, 0], shape: [{name: linestring, vertices: [[0, 0], "
          "[2, 0]]}, {name: linestring, vertices: [[0, 1], [2, 1]]}]}\n")
          .shapes;
  ASSERT_EQ(walls.segments.size(), 2U);
  EXPECT_EQ(walls.segments[0].b, Vec2(5, 4));
  EXPECT_EQ(walls.segments[1].b, Vec2(5, 5));
}

TEST(IrSim, SendsTheRobotToTheFirstOfSeveralGoals) {
  const auto goal = [](const std::string& goals) {
    return *ir_sim("robot: {state: [2, 3, 0], goal: " + goals + "}\n").goal;
  };
  EXPECT_EQ(goal("[7, 4, 1]"), Vec2(7, 4));
  EXPECT_EQ(goal("[[7, 4, 1], [2, 8, 0]]"), Vec2(7, 4));
  EXPECT_EQ(goal("[[[7, 4], [2, 8]], [[1, 1]]]"), Vec2(7, 4));
}

TEST(IrSim, KeepsTheHeadingOfTheRobot) {
  EXPECT_EQ(*ir_sim("robot: {state: [2, 3, 2.5], goal: [7, 4]}\n").start_heading_rad, 2.5);
  EXPECT_EQ(*ir_sim("robot: {state: [2, 3], goal: [7, 4]}\n").start_heading_rad, 0);
  EXPECT_FALSE(ir_sim("obstacle: {}\n").start_heading_rad);
}

TEST(IrSim, TakesTheFirstRobotThatIsPlacedByHand) {
  const ForeignWorld world = ir_sim(
      "robot:\n  - {number: 4, distribution: {name: circle, radius: 4}}\n"
      "  - {number: 2, distribution: {name: manual}, state: [[2, 3, 1], [4, 5, 2]], goal: [[7, 4], "
      "[3, 9]]}\n  - {state: [8, 8, 3], goal: [9, 9]}\n");
  EXPECT_EQ(*world.start, Vec2(2, 3));
  EXPECT_EQ(*world.goal, Vec2(7, 4));
  EXPECT_EQ(*world.start_heading_rad, 1);
  EXPECT_FALSE(ir_sim("robot: {distribution: {name: random}}\n").start);
}

TEST(IrSim, ReadsEmptyKeysAsNone) {
  const ForeignWorld world = read("world:\n  width: 5\n  plot:\nrobot:\nobstacle: ~\n");
  EXPECT_EQ(world.bounds->max, Vec2(5, 10));
  EXPECT_TRUE(world.shapes.empty());
  EXPECT_FALSE(world.start);
  EXPECT_EQ(ir_sim("obstacle: {state: null, shape:}\n").shapes.circles.at(0).center, Vec2(1, 1));
}

TEST(IrSim, ReadsTheKeysOfNewerVersions) {
  const ForeignWorld world = read(
      "irsim:\n  world: {width: 6, height: 4, step_mode: external, fog_map: true, "
      "fog_map_resolution: 0.2}\n  robot: {state: [1, 2, 0], group_name: blue, nav_graph: 3}\n"
      "  obstacle:\n    - state: [3, 2, 1.5707963267948966]\n      shape:\n"
      "        name: compound\n        parts:\n"
      "          - {name: circle, radius: 0.3, pose: [1, 0, 0]}\n"
      "          - {name: rectangle, length: 2, width: 0.5}\nother: {steps: 3}\n");
  EXPECT_EQ(world.bounds->max, Vec2(6, 4));
  EXPECT_EQ(*world.start, Vec2(1, 2));
  ASSERT_EQ(world.shapes.circles.size(), 1U);
  EXPECT_NEAR((world.shapes.circles[0].center - Vec2(3, 3)).norm(), 0, 1e-12);
  ASSERT_EQ(world.shapes.polygons.size(), 1U);
  EXPECT_NEAR((bounds_of(world.shapes.polygons[0]).max - Vec2(3.25, 3)).norm(), 0, 1e-12);
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
  EXPECT_EQ(error_in("obstacle: {" + circle + ", unobstructed: 2}\n"),
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
  EXPECT_EQ(error_in("obstacle:\n  - {number: 9, distribution: {name: random}, shape: {name: "
                     "circle, radius: 1}}\n"),
            "w.yaml:3: key 'obstacle[0].distribution': obstacles that IR-SIM places itself, at "
            "random or in a circle, are not read: give manual and their states");
  EXPECT_EQ(error_in("obstacle:\n  - {number: 9, shape: {name: polygon, random_shape: True, "
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
  EXPECT_EQ(error_in("obstacles: []\n"),
            "w.yaml:2: key 'obstacles': unknown key (allowed: world, robot, obstacle, gui, custom, "
            "irsim; did you mean 'obstacle'?)");
  EXPECT_EQ(error_in("obstacle: {shape: {name: rectangle, length: 1, width: 1, wheelbase: 3}}\n"),
            "w.yaml:2: key 'obstacle.shape.wheelbase': unknown key (allowed: name, radius, center, "
            "length, width, vertices, parts, pose, random_shape, is_convex)");
  EXPECT_EQ(error_in("obstacle: {shap: {name: circle, radius: 1}}\n").substr(0, 43),
            "w.yaml:2: key 'obstacle.shap': unknown key ");
  EXPECT_EQ(error_in("obstacle:\n  - {shape: {name: sphere}}\n"),
            "w.yaml:3: key 'obstacle[0].shape.name': expected one of circle, rectangle, polygon, "
            "linestring, compound, got 'sphere'");
}

}  // namespace
}  // namespace voronaut
