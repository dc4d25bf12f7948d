#include "voronaut/planners/problem/goal_placement.h"

#include <gtest/gtest.h>

namespace voronaut {
namespace {

const Bounds kBounds{Vec2(-10, -10), Vec2(10, 10)};

// A base that knows one point at (range, 0), seen from the origin.
ObstacleBase knowing_point_at(double range_m) {
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(0, 1));
  scan.max_range_m = 5;
  scan.range_m = {range_m};
  ObstacleBase base({});
  base.update(scan);
  return base;
}

TEST(GoalPlacement, IsTheGoalItselfWhereItKeepsItsClearance) {
  EXPECT_EQ(place_for_goal(Vec2(3, 0), 0.2, kBounds, {}, 0.4), Vec2(3, 0));
  const ObstacleBase base = knowing_point_at(2.5);
  EXPECT_EQ(place_for_goal(Vec2(3, 0), 0.2, kBounds, base.snapshot(), 0.4), Vec2(3, 0));
}

TEST(GoalPlacement, MovesWithinTheToleranceAwayFromAKnownPoint) {
  const ObstacleBase base = knowing_point_at(2.7);
  const auto place = place_for_goal(Vec2(3, 0), 0.2, kBounds, base.snapshot(), 0.4);
  ASSERT_TRUE(place);
  EXPECT_LE((*place - Vec2(3, 0)).norm(), 0.2);
  EXPECT_GE((*place - Vec2(2.7, 0)).norm(), 0.4);
}

TEST(GoalPlacement, IsNoneWhereNothingWithinTheToleranceIsClearOrWithinBounds) {
  const ObstacleBase base = knowing_point_at(2.95);
  EXPECT_FALSE(place_for_goal(Vec2(3, 0), 0.2, kBounds, base.snapshot(), 0.4));
  EXPECT_FALSE(place_for_goal(Vec2(11, 0), 0.2, kBounds, {}, 0.4));
}

}  // namespace
}  // namespace voronaut
