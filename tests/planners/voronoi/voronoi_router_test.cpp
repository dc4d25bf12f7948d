#include "voronaut/planners/voronoi/voronoi_router.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "voronaut/tests/planners/voronoi/flood_fill.h"
#include "voronaut/tests/planners/voronoi/voronoi_worlds.h"

namespace voronaut {
namespace {

using namespace voronoi_test;

constexpr double kClearance_m = 0.4;

Route plan(VoronoiRouter& router, const PointWorld& world,
           Shortening shortening = Shortening::channel) {
  const std::vector<Vec2> places{world.start, world.goal};
  router.observe(world.points, world.bounds, kClearance_m, places);
  RouteQuery query;
  query.start = world.start;
  query.goal = world.goal;
  query.shortening = shortening;
  return router.route(query);
}

Route plan(const PointWorld& world, Shortening shortening = Shortening::channel) {
  VoronoiRouter router;
  return plan(router, world, shortening);
}

void expect_sound(const Route& route, const PointWorld& world, std::uint64_t seed) {
  EXPECT_GE(clearance_m(route.points, world.points), kClearance_m) << "seed " << seed;
  EXPECT_EQ(route.points.front(), world.start) << "seed " << seed;
  EXPECT_EQ(route.points.back(), world.goal) << "seed " << seed;
  for (const Vec2& p : route.points) EXPECT_TRUE(world.bounds.contains(p)) << "seed " << seed;
}

PointWorld wall_with_gap(double gap_m) {
  PointWorld world;
  world.bounds = {Vec2(-5, -5), Vec2(5, 5)};
  world.start = {-3, -1.3};
  world.goal = {3, 2.1};
  add_wall(world.points, {0, -5.2}, {0, -gap_m / 2});
  add_wall(world.points, {0, gap_m / 2}, {0, 5.2});
  return world;
}

TEST(VoronoiRouter, NeverComesCloserThanTheClearance) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const PointWorld worlds[] = {forest(random, 0.15, 14), rooms(random),
                                 scattered(random, 150, 14)};
    for (const PointWorld& world : worlds)
      for (const Shortening how : {Shortening::none, Shortening::shortcut, Shortening::channel})
        if (const Route route = plan(world, how); !route.points.empty())
          expect_sound(route, world, seed);
  }
}

// Bounds tighter than any frame: the way along the border is part of the graph.
TEST(VoronoiRouter, FindsAPathExactlyWhereAFloodFillDoes) {
  int found = 0, closed = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    const PointWorld world = scattered(random, 60 + 2 * seed, 9);
    const Route route = plan(world);
    switch (flood_fill(world, kClearance_m)) {
      case Connected::yes:
        EXPECT_EQ(route.verdict, Route::Verdict::found) << "seed " << seed;
        ++found;
        break;
      case Connected::no:
        EXPECT_TRUE(route.proved_no_path()) << "seed " << seed;
        ++closed;
        break;
      case Connected::too_close_to_call:
        break;
    }
    if (!route.points.empty()) expect_sound(route, world, seed);
  }
  EXPECT_GT(found, 20);
  EXPECT_GT(closed, 20);
}

TEST(VoronoiRouter, PassesGapsOneInTenThousandWiderThanTheVehicle) {
  for (const double factor : {1.0001, 1.001, 1.01, 1.1, 2.0}) {
    const PointWorld world = wall_with_gap(factor * 2 * kClearance_m);
    const Route route = plan(world);
    ASSERT_EQ(route.verdict, Route::Verdict::found) << factor;
    expect_sound(route, world, 0);
  }
}

TEST(VoronoiRouter, ProvesThatGapsOneInTenThousandNarrowerAreClosed) {
  for (const double factor : {0.5, 0.99, 0.999, 0.9999})
    EXPECT_EQ(plan(wall_with_gap(factor * 2 * kClearance_m)).verdict, Route::Verdict::not_connected)
        << factor;
}

// The prototype's fourth fault: the 30 vertices closest to a start beside a long wall lie behind
// the wall, and "no path" was the answer.
TEST(VoronoiRouter, LeavesAStartBesideALongWall) {
  PointWorld world;
  world.bounds = {Vec2(-5, -30), Vec2(40, 30)};
  for (double y = -25; y <= 25; y += 0.08) world.points.emplace_back(0, y);
  for (double y = -25; y <= 25; y += 0.08) world.points.emplace_back(-0.9, y + 0.04);
  world.start = {0.45, 0};
  world.goal = {-3, 0};
  const Route route = plan(world);
  ASSERT_EQ(route.verdict, Route::Verdict::found);
  expect_sound(route, world, 0);
}

TEST(VoronoiRouter, LeavesADeadEnd) {
  PointWorld world;
  world.bounds = {Vec2(-6, -6), Vec2(6, 6)};
  add_wall(world.points, {3, -0.45}, {-3, -0.45});
  add_wall(world.points, {3, 0.45}, {-3, 0.45});
  add_wall(world.points, {3, -0.45}, {3, 0.45});
  world.start = {2.55, 0};
  world.goal = {5, 0};
  const Route route = plan(world);
  ASSERT_EQ(route.verdict, Route::Verdict::found);
  expect_sound(route, world, 0);
  EXPECT_LT(route.length_m, 5.6 + 6.5 + 4);
}

TEST(VoronoiRouter, ProvesThatAnEnclosedGoalCannotBeReached) {
  PointWorld world;
  world.bounds = {Vec2(-6, -6), Vec2(6, 6)};
  world.start = {-4, 0};
  world.goal = {2, 0};
  add_circle(world.points, world.goal, 1.2);
  EXPECT_EQ(plan(world).verdict, Route::Verdict::not_connected);
  add_circle(world.points, world.start, 0.45);
  EXPECT_TRUE(plan(world).proved_no_path());
}

TEST(VoronoiRouter, GoesAroundTheOutsideOfAllThatIsKnown) {
  PointWorld world;
  world.start = {-2, 0};
  world.goal = {2, 0.1};
  add_wall(world.points, {0, -3}, {0, 3});
  for (const double bound : {3.4001, 3.5, 20.0, 800.0, 1e6, 1e300}) {
    world.bounds = {Vec2(-bound, -bound), Vec2(bound, bound)};
    const Route route = plan(world);
    ASSERT_EQ(route.verdict, Route::Verdict::found) << bound;
    expect_sound(route, world, 0);
    EXPECT_NEAR(route.length_m, 7.9, 0.3) << bound;
  }
  world.bounds = {Vec2(-3.399, -3.399), Vec2(3.399, 3.399)};
  EXPECT_EQ(plan(world).verdict, Route::Verdict::not_connected);
}

TEST(VoronoiRouter, ManagesWithNoPointAndWithOneOrTwo) {
  PointWorld world;
  world.bounds = {Vec2(-3, -3), Vec2(3, 3)};
  world.start = {-2, 0};
  world.goal = {2, 0};
  EXPECT_EQ(plan(world).length_m, 4);
  world.points = {Vec2(0, 0)};
  // Two tangents of length sqrt(2^2 - 0.4^2) and the arc between them.
  const double one = 2 * std::sqrt(4 - 0.16) + 0.4 * (M_PI - 2 * std::acos(0.2));
  EXPECT_NEAR(plan(world).length_m, one, 1e-3);
  world.points.emplace_back(0, 0.85);
  const Route between = plan(world);
  ASSERT_EQ(between.verdict, Route::Verdict::found);
  expect_sound(between, world, 0);
  EXPECT_NEAR(between.length_m, one, 1e-3);
  world.points.emplace_back(0, 0.85);
  world.points.emplace_back(0, 0);
  EXPECT_EQ(plan(world).length_m, between.length_m);
}

TEST(VoronoiRouter, AnswersTheSameWhetherItGrewOrWasBuiltAnew) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const PointWorld world = forest(random, 0.2, 14);
    VoronoiRouter grown;
    for (std::size_t n = 0; n < world.points.size(); n += 97) {
      PointWorld part = world;
      part.points.resize(n);
      plan(grown, part);
    }
    const Route a = plan(grown, world);
    const Route b = plan(world);
    EXPECT_EQ(grown.rebuilds(), 1u);
    ASSERT_EQ(a.points.size(), b.points.size()) << "seed " << seed;
    for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i], b.points[i]);
  }
}

// The lattice is four times as coarse there, and the margin for it wider.
TEST(VoronoiRouter, KeepsItsClearanceInBoundsOfTwentyKilometres) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    PointWorld world = forest(random, 0.15, 14);
    world.bounds = {Vec2(-10'000, -10'000), Vec2(10'000, 10'000)};
    world.points.emplace_back(-9'990, -9'990);  // known, and far away
    world.points.emplace_back(9'990, 9'990);
    const Route route = plan(world);
    EXPECT_EQ(route.verdict, Route::Verdict::found) << "seed " << seed;
    expect_sound(route, world, seed);
  }
}

TEST(VoronoiRouter, StartsAnewWhenPointsVanish) {
  VoronoiRouter router;
  PointWorld world = wall_with_gap(0.5);
  EXPECT_TRUE(plan(router, world).proved_no_path());
  world.points.resize(world.points.size() / 2);
  EXPECT_EQ(plan(router, world).verdict, Route::Verdict::found);
}

TEST(VoronoiRouter, TurnsAndMovesWithTheWorld) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    const PointWorld world = scattered(random, 120, 14);
    const Route here = plan(world);
    PointWorld there = world;
    const auto quarter_turn = [](const Vec2& p) -> Vec2 { return left_of(p) + Vec2(123.4, -77.7); };
    for (Vec2& p : there.points) p = quarter_turn(p);
    there.start = quarter_turn(world.start);
    there.goal = quarter_turn(world.goal);
    const Vec2 a = quarter_turn(world.bounds.min), b = quarter_turn(world.bounds.max);
    there.bounds = {a.cwiseMin(b), a.cwiseMax(b)};
    const Route turned = plan(there);
    EXPECT_EQ(turned.verdict, here.verdict) << "seed " << seed;
    EXPECT_NEAR(turned.length_m, here.length_m, 1e-3) << "seed " << seed;
  }
}

TEST(VoronoiRouter, GoesWhereTheGoalsToleranceAllows) {
  PointWorld world = wall_with_gap(3);
  world.goal = {0.35, 2.5};  // 5 cm too close to the wall
  VoronoiRouter router;
  const std::vector<Vec2> places{world.start, world.goal};
  router.observe(world.points, world.bounds, kClearance_m, places);
  RouteQuery query;
  query.start = world.start;
  query.goal = world.goal;
  const Route near = router.route_near(query, 0.2);
  ASSERT_EQ(near.verdict, Route::Verdict::found);
  EXPECT_NEAR((near.points.back() - world.goal).norm(), 0.05, 0.01);
  EXPECT_GE(clearance_m(near.points, world.points), kClearance_m);
  EXPECT_EQ(router.route_near(query, 0.03).verdict, Route::Verdict::goal_closed);
}

TEST(VoronoiRouter, LeavesAStartThatIsTooCloseWhereTheCheckAllows) {
  PointWorld world = wall_with_gap(1);
  world.start = {-0.1, 0};
  const MotionCheck relaxed = [&](const Vec2& a, const Vec2& b) {
    const bool at_start = (a - world.start).norm() <= kClearance_m;
    return clearance_m({a, b}, world.points) >= (at_start ? 0.09 : kClearance_m);
  };
  world.points.emplace_back(0, 0);  // the start is 10 cm away from this one, and 40 cm are asked
  VoronoiRouter router;
  const std::vector<Vec2> places{world.start, world.goal};
  router.observe(world.points, world.bounds, kClearance_m, places);
  RouteQuery query;
  query.start = world.start;
  query.goal = {-3, 1};
  EXPECT_EQ(router.route(query).verdict, Route::Verdict::unproven);
  query.motion_is_clear = relaxed;
  const Route route = router.route(query);
  ASSERT_EQ(route.verdict, Route::Verdict::found);
  for (std::size_t i = 1; i < route.points.size(); ++i)
    EXPECT_TRUE(relaxed(route.points[i - 1], route.points[i]));
}

}  // namespace
}  // namespace voronaut
