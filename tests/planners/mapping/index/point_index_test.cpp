#include "voronaut/planners/mapping/index/point_index.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"

namespace voronaut {
namespace {

// Points on arcs, as a range finder sees them, and some alone.
PointIndex random_points(Random& random, double side_m, double spacing_m) {
  PointIndex index(spacing_m);
  const std::size_t arcs = 1 + random.below(20);
  for (std::size_t arc = 0; arc < arcs; ++arc) {
    Vec2 p{random.uniform(-side_m / 2, side_m / 2), random.uniform(-side_m / 2, side_m / 2)};
    Vec2 step{random.uniform(-spacing_m, spacing_m), spacing_m};
    const std::size_t count = 1 + random.below(15);
    for (std::size_t i = 0; i < count; ++i) {
      index.add(p);
      p += step;
      step += 0.2 * left_of(step);
    }
  }
  return index;
}

Vec2 random_place(Random& random, double side_m) {
  return {random.uniform(-side_m / 2, side_m / 2), random.uniform(-side_m / 2, side_m / 2)};
}

PointId nearest_of_all(const PointIndex& index, const Vec2& p, double within_m) {
  PointId nearest = PointIndex::kNone;
  double nearest_sq = kInfinity;
  for (PointId id = 0; id < index.size(); ++id) {
    const double apart_sq = (index[id] - p).squaredNorm();
    if (apart_sq > within_m * within_m || apart_sq >= nearest_sq) continue;
    nearest = id;
    nearest_sq = apart_sq;
  }
  return nearest;
}

double distance_of_all(const PointIndex& index, const Segment& segment, double within_m) {
  double smallest_m = within_m;
  for (const Vec2& p : index.points()) smallest_m = std::min(smallest_m, distance(p, segment));
  return smallest_m;
}

TEST(PointIndex, FindsWhatASearchThroughAllPointsFinds) {
  int found = 0;
  int hit = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const double side_m = random.uniform(1, 30);
    const PointIndex index = random_points(random, side_m, random.uniform(0.03, 0.5));
    for (int query = 0; query < 100; ++query) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " query " + std::to_string(query));
      const Vec2 a = random_place(random, 1.5 * side_m);
      const Vec2 b = query % 5 == 0 ? a : a + random_place(random, 5);
      const double reach_m = query % 7 == 0 ? random.uniform(0, 20) : random.uniform(0, 1);
      const PointId nearest = nearest_of_all(index, a, reach_m);
      ASSERT_EQ(index.nearest(a, reach_m), nearest);
      ASSERT_EQ(index.nearest_closer_than(a, reach_m), nearest);
      ASSERT_EQ(index.is_clear(a, reach_m), nearest == PointIndex::kNone);
      const double distance_m = distance_of_all(index, {a, b}, reach_m);
      ASSERT_EQ(index.is_clear(a, b, reach_m), !(distance_m < reach_m));
      ASSERT_NEAR(std::sqrt(index.distance_sq(a, b, reach_m)), distance_m, 1e-9);
      found += nearest != PointIndex::kNone;
      hit += distance_m < reach_m;
    }
  }
  EXPECT_GT(found, 5'000);
  EXPECT_GT(hit, 8'000);
}

// With the field: for the expected distance, for others, and after points that it does not know.
TEST(PointIndex, AnswersTheSameWhenChecksWereExpected) {
  int clear = 0;
  int touching = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const double side_m = random.uniform(1, 30);
    const double expected_m = seed % 10 == 0 ? 0 : random.uniform(0.05, 1.6);
    PointIndex index = random_points(random, side_m, random.uniform(0.03, 0.5));
    for (int query = 0; query < 200; ++query) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " query " + std::to_string(query));
      if (query % 20 == 0) index.expect_checks(query == 100 ? 0.7 * expected_m : expected_m);
      if (query % 20 == 15) index.add(random_place(random, side_m));
      const Vec2 a = random_place(random, 1.5 * side_m);
      const Vec2 b = query % 5 == 0 ? a : a + random_place(random, query % 3 == 0 ? 20 : 4);
      const double reach_m = query % 4 == 0 ? random.uniform(0, 1.8) : expected_m;
      const double distance_m = distance_of_all(index, {a, b}, 2);
      const bool place_is_clear = !(distance_of_all(index, {a, a}, 2) < reach_m);
      ASSERT_EQ(index.is_clear(a, reach_m), place_is_clear);
      ASSERT_EQ(index.is_clear(a, b, reach_m), !(distance_m < reach_m));
      clear += place_is_clear;
      touching += distance_m < reach_m;
    }
  }
  EXPECT_GT(clear, 20'000);
  EXPECT_GT(touching, 15'000);
}

TEST(PointIndex, ReachesToInfinity) {
  Random random(3);
  const PointIndex index = random_points(random, 10, 0.1);
  for (int i = 0; i < 100; ++i) {
    const Vec2 far = random_place(random, 1e6);
    EXPECT_EQ(index.nearest(far, kInfinity), nearest_of_all(index, far, kInfinity));
    EXPECT_EQ(index.nearest(far, 0.1), PointIndex::kNone);
    EXPECT_EQ(index.is_clear(far, 0.4), index.nearest(far, 0.4) == PointIndex::kNone);
  }
}

TEST(PointIndex, DoesNotCountAPointAtExactlyTheDistance) {
  PointIndex index(0.1);
  index.add({1, 2});
  index.expect_checks(0.5);
  EXPECT_TRUE(index.is_clear({1, 2.5}, 0.5));
  EXPECT_FALSE(index.is_clear({1, 2.5}, std::nextafter(0.5, 1)));
  EXPECT_EQ(index.nearest_closer_than({1, 2.5}, 0.5), PointIndex::kNone);
  EXPECT_EQ(index.nearest({1, 2.5}, 0.5), PointId{0});
  EXPECT_TRUE(index.is_clear({0, 2.5}, {3, 2.5}, 0.5));
  EXPECT_FALSE(index.is_clear({0, 2.5}, {3, 2.5}, std::nextafter(0.5, 1)));
}

TEST(PointIndex, PrefersTheEarliestOfEquallyNearPoints) {
  PointIndex index(0.1);
  index.add({0, 1});
  index.add({0, -1});
  index.add({1, 0});
  EXPECT_EQ(index.nearest({0, 0}, 2), PointId{0});
  EXPECT_EQ(index.nearest_closer_than({0, 0}, 2), PointId{0});
}

TEST(PointIndex, AnEmptyOneIsClearEverywhere) {
  const PointIndex index(0.1);
  EXPECT_TRUE(index.is_clear({0, 0}, 100));
  EXPECT_TRUE(index.is_clear({0, 0}, {1e6, 3}, kInfinity));
  EXPECT_EQ(index.nearest({0, 0}, kInfinity), PointIndex::kNone);
}

TEST(PointIndexDeathTest, RefusesCoordinatesThatAreNotNumbers) {
  PointIndex index(0.1);
  EXPECT_DEATH(index.add({std::nan(""), 0}), "not numbers");
  EXPECT_DEATH(index.add({0, kInfinity}), "not numbers");
}

}  // namespace
}  // namespace voronaut
