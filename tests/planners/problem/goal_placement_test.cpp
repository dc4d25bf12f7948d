#include "voronaut/planners/problem/goal_placement.h"

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"

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

TEST(GoalPlacement, IsTheNearestWhereOnlyTheRimOfTheToleranceIsClear) {
  const ObstacleBase base = knowing_point_at(2.8);
  const auto place = place_for_goal(Vec2(3, 0), 0.2, kBounds, base.snapshot(), 0.395);
  ASSERT_TRUE(place);
  EXPECT_NEAR((*place - Vec2(3.195, 0)).norm(), 0, 1e-6);
}

TEST(GoalPlacement, IsNoneWhereNothingWithinTheToleranceIsClearOrWithinBounds) {
  const ObstacleBase base = knowing_point_at(2.95);
  EXPECT_FALSE(place_for_goal(Vec2(3, 0), 0.2, kBounds, base.snapshot(), 0.4));
  EXPECT_FALSE(place_for_goal(Vec2(11, 0), 0.2, kBounds, {}, 0.4));
}

// A base that knows a dozen points within half a metre of (3, 0), seen from the origin.
ObstacleBase knowing_a_thicket(Random& random) {
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(0.3, 12));
  scan.max_range_m = 5;
  for (int i = 0; i < 12; ++i) scan.range_m.push_back(random.uniform(2.5, 3.5));
  ObstacleBase base({});
  base.update(scan);
  return base;
}

bool any_of_a_fine_grid_fits(const Vec2& goal, double tolerance_m, const Bounds& bounds,
                             const ObstacleSnapshot& known, double clearance_m) {
  constexpr int kSteps = 60;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int k = -kSteps; k <= kSteps; ++k) {
      const Vec2 offset = Vec2(i, k) * (tolerance_m / kSteps);
      if (offset.norm() > tolerance_m || !bounds.contains(goal + offset)) continue;
      if (known.disc_is_clear(goal + offset, clearance_m)) return true;
    }
  }
  return false;
}

TEST(GoalPlacement, IsNoneOnlyWhereAFineGridFindsNoPlaceEither) {
  const Vec2 goal(3, 0);
  constexpr double kTolerance_m = 0.2;
  int none = 0;
  int places = 0;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    Random random(seed);
    const ObstacleBase base = knowing_a_thicket(random);
    const double clearance_m = random.uniform(0.05, 0.25);
    const Bounds bounds{Vec2(-1, random.uniform(-0.3, 0)), Vec2(10, 10)};
    const auto place = place_for_goal(goal, kTolerance_m, bounds, base.snapshot(), clearance_m);
    if (place) {
      ++places;
      EXPECT_LE((*place - goal).norm(), kTolerance_m);
      EXPECT_TRUE(bounds.contains(*place));
      EXPECT_TRUE(base.snapshot().disc_is_clear(*place, clearance_m)) << seed;
    } else {
      ++none;
      EXPECT_FALSE(
          any_of_a_fine_grid_fits(goal, kTolerance_m, bounds, base.snapshot(), clearance_m))
          << seed;
    }
  }
  EXPECT_GT(none, 300);
  EXPECT_GT(places, 300);
}

}  // namespace
}  // namespace voronaut
