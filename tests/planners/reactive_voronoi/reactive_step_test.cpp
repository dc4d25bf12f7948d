#include "voronaut/planners/reactive_voronoi/reactive_step.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/planners/reactive_voronoi/reactive_flight.h"

namespace voronaut {
namespace {

using Config = ReactiveVoronoiConfig;
using test::FlightEnd;
using test::FlightScene;
using test::Flown;
using test::fly;

const double kHalfRoot = std::sqrt(0.5);
const std::array<Vec2, 8> kBearings{
    Vec2(1, 0),  Vec2(kHalfRoot, kHalfRoot),   Vec2(0, 1),  Vec2(-kHalfRoot, kHalfRoot),
    Vec2(-1, 0), Vec2(-kHalfRoot, -kHalfRoot), Vec2(0, -1), Vec2(kHalfRoot, -kHalfRoot)};

RelevantObstacle obstacle(std::vector<Vec2> points, const Vec2& closest) {
  RelevantObstacle result;
  result.points_world = std::move(points);
  result.closest_world = closest;
  return result;
}

ReactiveMode first_mode(const FlightScene& scene, const Config& config) {
  test::FlightConfig once;
  once.time_limit_s = 0.01;
  return fly(scene, config, once).decisions.front().mode;
}

TEST(Subgoal, BypassIncrementsTheExtremePointAlongTheAxesAsPrinted) {
  const RelevantObstacle wall = obstacle({{3, 1}, {2.5, 1.5}, {2, 2}, {1.5, 2.5}}, {2, 2});
  const Config published;
  // Right to left as seen from the origin: (3, 1) is the right end.
  EXPECT_EQ(bypass_subgoal(wall, Side::right, {0, 0}, published), Vec2(3.5, 0.5));
  EXPECT_EQ(bypass_subgoal(wall, Side::left, {0, 0}, published), Vec2(1, 3));
}

TEST(Subgoal, OffsetAcrossTheLineOfSightIsThePrintedOneOnACourseOf45Degrees) {
  const RelevantObstacle post = obstacle({{2, 2}}, {2, 2});
  const Config published;
  Config repaired;
  repaired.offset = Config::Offset::line_of_sight;
  for (const Side side : {Side::left, Side::right}) {
    const Vec2 a = bypass_subgoal(post, side, {0, 0}, published);
    const Vec2 b = bypass_subgoal(post, side, {0, 0}, repaired);
    EXPECT_NEAR((a - b).norm(), 0, 1e-12);
  }
  EXPECT_GT(cross({2, 2}, bypass_subgoal(post, Side::left, {0, 0}, repaired)), 0);
  EXPECT_LT(cross({2, 2}, bypass_subgoal(post, Side::right, {0, 0}, repaired)), 0);
}

TEST(Subgoal, BearingOrderFindsTheEndsThatStoredOrderMisses) {
  // Stored as a merged cluster is: the right end lies in the middle of the list.
  const RelevantObstacle merged = obstacle({{4, 0}, {4, 1}, {4, -2}, {4, -1}}, {4, 0});
  EXPECT_EQ(extreme_point(merged, Side::right, {0, 0}, Config::Extremes::stored_order), Vec2(4, 0));
  EXPECT_EQ(extreme_point(merged, Side::right, {0, 0}, Config::Extremes::bearing_order),
            Vec2(4, -2));
  EXPECT_EQ(extreme_point(merged, Side::left, {0, 0}, Config::Extremes::bearing_order), Vec2(4, 1));
}

TEST(Subgoal, BetweenIsTheMiddleOfTheTwoClosestPoints) {
  const RelevantObstacle left = obstacle({{2, 1}, {3, 1}}, {2, 1});
  const RelevantObstacle right = obstacle({{3, -1}}, {3, -1});
  EXPECT_EQ(between_subgoal(left, right), Vec2(2.5, 0));
}

TEST(GoalCorridor, EndsAtTheVehicleAndAtTheGoal) {
  EXPECT_TRUE(in_goal_corridor({2, 0.7}, {0, 0}, {5, 0}, 0.75));
  EXPECT_FALSE(in_goal_corridor({2, 0.8}, {0, 0}, {5, 0}, 0.75));
  EXPECT_FALSE(in_goal_corridor({-0.1, 0}, {0, 0}, {5, 0}, 0.75));
  EXPECT_FALSE(in_goal_corridor({5.1, 0}, {0, 0}, {5, 0}, 0.75));
}

TEST(ReactiveStep, PicksEachModeOfThePapers) {
  for (const Config& config : {Config::as_published(), Config::repaired()}) {
    const Vec2 goal(10, 10);
    const Vec2 ahead(kHalfRoot, kHalfRoot);
    const Vec2 left = left_of(ahead);
    EXPECT_EQ(first_mode({{}, {0, 0}, goal}, config), ReactiveMode::none);
    EXPECT_EQ(first_mode({{{2 * ahead - 0.3 * left, 0.5}}, {0, 0}, goal}, config),
              ReactiveMode::left);
    EXPECT_EQ(first_mode({{{2 * ahead + 0.3 * left, 0.5}}, {0, 0}, goal}, config),
              ReactiveMode::right);
    EXPECT_EQ(
        first_mode({{{2 * ahead + 1.1 * left, 0.5}, {2 * ahead - 1.1 * left, 0.5}}, {0, 0}, goal},
                   config),
        ReactiveMode::between);
  }
}

TEST(ReactiveStep, RepairedIgnoresWhatDoesNotBlockTheWay) {
  const Vec2 goal(10, 0);
  const FlightScene beside{{{{2, 1.6}, 0.5}}, {0, 0}, goal};
  EXPECT_NE(first_mode(beside, Config::as_published()), ReactiveMode::none);
  EXPECT_EQ(first_mode(beside, Config::repaired()), ReactiveMode::none);
}

TEST(ReactiveStep, RepairedPassesObstaclesOnOneSideTogether) {
  // Two posts to the right of the way, one behind the other: not between them.
  const FlightScene scene{{{{1.2, -0.45}, 0.2}, {{2.2, -0.5}, 0.2}}, {0, 0}, {10, 0}};
  test::FlightConfig once;
  once.time_limit_s = 0.01;
  once.mapping.merge_distance_m = 0.3;
  EXPECT_EQ(fly(scene, Config::repaired(), once).decisions.front().mode, ReactiveMode::left);
  Config closest = Config::repaired();
  closest.pairing = Config::Pairing::closest;
  EXPECT_EQ(fly(scene, closest, once).decisions.front().mode, ReactiveMode::between);
}

TEST(ReactiveStep, HysteresisKeepsTheSideOnceChosen) {
  const FlightScene scene{{{{2, -0.05}, 0.5}}, {0, 0}, {10, 0}};
  const FlightScene other_side{{{{2, 0.05}, 0.5}}, {0, 0}, {10, 0}};
  EXPECT_EQ(first_mode(scene, Config::repaired()), ReactiveMode::left);
  EXPECT_EQ(first_mode(other_side, Config::repaired()), ReactiveMode::right);
  const Flown flown = fly(scene, Config::repaired(), {});
  EXPECT_EQ(flown.end, FlightEnd::goal);
  for (const ReactiveDecision& each : flown.decisions) EXPECT_NE(each.mode, ReactiveMode::right);
}

// Turning the world turns every decision, as long as nothing chooses by the axes. Turns by
// multiples of 90 deg are exact in floating point up to the sensor's rays.
TEST(ReactiveStep, RepairedDecisionsTurnWithTheWorld) {
  constexpr std::uint64_t kSeed = 5;
  for (std::uint64_t seed = kSeed; seed < kSeed + 5; ++seed) {
    const FlightScene scene = test::paper_like_scene({1, 0}, seed);
    const Flown straight = fly(scene, Config::repaired(), {});
    for (const Vec2& bearing : kBearings) {
      const Flown flown = fly(test::turned(scene, bearing), Config::repaired(), {});
      ASSERT_EQ(flown.decisions.size(), straight.decisions.size()) << "seed " << seed;
      for (std::size_t i = 0; i < flown.decisions.size(); ++i) {
        const Vec2& p = straight.decisions[i].subgoal_world;
        const Vec2 turned = p.x() * bearing + p.y() * left_of(bearing);
        ASSERT_EQ(flown.decisions[i].mode, straight.decisions[i].mode)
            << "seed " << seed << " step " << i << " bearing " << bearing.transpose();
        ASSERT_NEAR((flown.decisions[i].subgoal_world - turned).norm(), 0, 1e-6)
            << "seed " << seed << " step " << i << " bearing " << bearing.transpose();
      }
    }
  }
}

double success_rate(const Vec2& bearing, const Config& config, std::uint64_t first_seed, int n) {
  int arrived = 0;
  for (int i = 0; i < n; ++i) {
    const FlightScene scene =
        test::paper_like_scene(bearing, first_seed + static_cast<std::uint64_t>(i));
    arrived += fly(scene, config, {}).end == FlightEnd::goal;
  }
  return static_cast<double>(arrived) / n;
}

TEST(ReactiveStep, RepairedArrivesAtEveryBearing) {
  std::uint64_t seed = 1000;
  for (const Vec2& bearing : kBearings) {
    EXPECT_GE(success_rate(bearing, Config::repaired(), seed, 60), 0.98) << bearing.transpose();
    seed += 1000;
  }
}

TEST(ReactiveStep, AsPublishedWorksOnThePapersCourseOnly) {
  EXPECT_GE(success_rate({kHalfRoot, kHalfRoot}, Config::as_published(), 20'000, 60), 0.6);
  EXPECT_LT(success_rate({kHalfRoot, -kHalfRoot}, Config::as_published(), 30'000, 60), 0.2);
  EXPECT_LT(success_rate({1, 0}, Config::as_published(), 40'000, 60), 0.5);
}

// One factor at a time, as the published planner is repaired (and unrepaired).
TEST(ReactiveStep, EachOfTheLargeRepairsIsNeeded) {
  const Vec2 bearing(kHalfRoot, -kHalfRoot);
  Config axis = Config::repaired();
  axis.offset = Config::Offset::axis;
  EXPECT_LT(success_rate(bearing, axis, 50'000, 40), 0.5);
  Config stored = Config::repaired();
  stored.source = Config::Source::map;
  stored.extremes = Config::Extremes::stored_order;
  EXPECT_LT(success_rate(bearing, stored, 50'000, 40), 0.5);
}

TEST(ReactiveStep, ClosestPairNeedsTheNarrowFieldOfViewAndOnePerSideDoesNot) {
  test::FlightConfig all_round;
  all_round.field_of_view_rad = 6.283185307179586;
  all_round.rays = 360;
  const auto arrived = [&](const Config& config) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed)
      count += fly(test::paper_like_scene({0.6, 0.8}, 77'000 + seed), config, all_round).end ==
               FlightEnd::goal;
    return count;
  };
  Config closest = Config::repaired();
  closest.pairing = Config::Pairing::closest;
  EXPECT_GE(arrived(Config::repaired()), 98);
  EXPECT_LT(arrived(closest), 92);
}

}  // namespace
}  // namespace voronaut
