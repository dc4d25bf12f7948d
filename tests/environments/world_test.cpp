#include "voronaut/environments/world.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(World, AnswersFromItsShapes) {
  Shapes shapes;
  shapes.circles = {{Vec2(2, 0), 1}};
  const World world({Vec2(-5, -5), Vec2(5, 5)}, shapes);
  EXPECT_DOUBLE_EQ(world.clearance_m(Vec2(0, 0)), 1);
  EXPECT_DOUBLE_EQ(world.clearance_m(Vec2(2, 0)), -1);
  EXPECT_TRUE(world.segment_is_clear(Vec2(0, -3), Vec2(0, 3), 1));
  EXPECT_FALSE(world.segment_is_clear(Vec2(0, -3), Vec2(0, 3), 1.01));
  EXPECT_EQ(world.shapes().circles.size(), 1U);
}

TEST(World, BoundsAreNoWalls) {
  const World world({Vec2(0, 0), Vec2(1, 1)}, {});
  EXPECT_EQ(world.clearance_m(Vec2(0, 0)), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(world.segment_is_clear(Vec2(0.5, 0.5), Vec2(9, 9), 0.5));
}

TEST(World, RefusesBoundsWithoutAreaAndBadShapes) {
  EXPECT_THROW(World({Vec2(0, 0), Vec2(0, 1)}, {}), std::invalid_argument);
  EXPECT_THROW(World({Vec2(0, 0), Vec2(1, -1)}, {}), std::invalid_argument);
  EXPECT_THROW(World({Vec2(0, 0), Vec2(1, std::nan(""))}, {}), std::invalid_argument);
  Shapes bad;
  bad.circles = {{Vec2(0, 0), -1}};
  EXPECT_THROW(World({Vec2(0, 0), Vec2(1, 1)}, bad), std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
