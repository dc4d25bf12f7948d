#include "voronaut/planners/mapping/points/convex_polygon.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/micro/peers/boost_intersects.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/mapping/points/orientation.h"

namespace voronaut {
namespace {

__extension__ using Quad = __float128;  // exact for what these tests multiply

int exact_turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Quad turn =
      (Quad{a.x()} - c.x()) * (Quad{b.y()} - c.y()) - (Quad{a.y()} - c.y()) * (Quad{b.x()} - c.x());
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// The plain rule, by exact turns: no common point means some edge, or the order along the common
// line, keeps them apart.
bool touch_exactly(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const auto apart = [](const std::vector<Vec2>& p, const std::vector<Vec2>& q) {
    for (std::size_t i = 0; i < p.size() && p.size() > 1; ++i) {
      bool all = true;
      for (const Vec2& v : q) all = all && exact_turn(p[i], p[(i + 1) % p.size()], v) < 0;
      if (all) return true;
    }
    return false;
  };
  return boxes_touch(bounding_box(a), bounding_box(b)) && !apart(a, b) && !apart(b, a);
}

// The hull of one to seven random points of a grid with the given pitch, or of the plane.
std::vector<Vec2> random_hull(Random& random, double pitch_m) {
  std::vector<Vec2> hull;
  const Vec2 around{random.uniform(-2, 2), random.uniform(-2, 2)};
  const std::size_t count = 1 + random.below(7);
  while (hull.size() < count) {
    Vec2 p = around + Vec2{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    if (pitch_m > 0)
      p = {pitch_m * std::round(p.x() / pitch_m), pitch_m * std::round(p.y() / pitch_m)};
    hull.push_back(p);
  }
  reduce_to_convex_hull(hull);
  return hull;
}

TEST(Orientation, IsExactNextToCollinearity) {
  Random random(7);
  int collinear = 0;
  for (int i = 0; i < 200'000; ++i) {
    // c lies on the line through a and b up to rounding.
    const Vec2 a{random.uniform(-10, 10), random.uniform(-10, 10)};
    const Vec2 b{random.uniform(-10, 10), random.uniform(-10, 10)};
    const double t = static_cast<double>(random.below(9)) / 8;
    const Vec2 c = a + t * (b - a);
    ASSERT_EQ(sign(orientation(a, b, c)), exact_turn(a, b, c)) << i;
    collinear += exact_turn(a, b, c) == 0;
  }
  EXPECT_GT(collinear, 1000);
}

TEST(ConvexHull, OfPointsAddedOneByOneEqualsTheHullOfAll) {
  for (std::uint64_t seed = 1; seed <= 20'000; ++seed) {
    Random random(seed);
    const double pitch_m = seed % 2 == 0 ? 0.5 : 0;
    std::vector<Vec2> all;
    std::vector<Vec2> hull;
    std::size_t vertex = 0;
    for (int i = 0; i < 12; ++i) {
      Vec2 p{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
      if (pitch_m > 0)
        p = {pitch_m * std::round(p.x() / pitch_m), pitch_m * std::round(p.y() / pitch_m)};
      all.push_back(p);
      std::vector<Vec2> expected = all;
      reduce_to_convex_hull(expected);
      const std::vector<Vec2> before = hull;
      // Sometimes a wrong place to look at first.
      if (i % 4 == 0) vertex = random.below(14);
      const bool grew = add_to_convex_hull(hull, p, vertex);
      if (grew && before.size() > 2) {
        ASSERT_EQ(hull[vertex], p) << "seed " << seed << " point " << i;
      }
      ASSERT_EQ(hull, expected) << "seed " << seed << " point " << i;
      ASSERT_EQ(grew, hull != before) << "seed " << seed << " point " << i;
    }
  }
}

TEST(ConvexHull, HoldsAllPointsAndTurnsLeftEverywhere) {
  for (std::uint64_t seed = 1; seed <= 5'000; ++seed) {
    Random random(seed);
    std::vector<Vec2> points;
    for (int i = 0; i < 15; ++i) {
      points.push_back(
          {static_cast<double>(random.below(6)), static_cast<double>(random.below(6))});
    }
    std::vector<Vec2> hull = points;
    reduce_to_convex_hull(hull);
    const std::size_t n = hull.size();
    for (std::size_t i = 0; i < n && n > 2; ++i) {
      ASSERT_GT(exact_turn(hull[i], hull[(i + 1) % n], hull[(i + 2) % n]), 0) << "seed " << seed;
      for (const Vec2& p : points) {
        ASSERT_GE(exact_turn(hull[i], hull[(i + 1) % n], p), 0) << "seed " << seed;
      }
    }
  }
}

// On a grid whose pitch is a power of two every coordinate and product is exact, so that Boost's
// answers are exact as well: touching in a point, sharing an edge, collinear and degenerate pairs
// must all agree.
TEST(ConvexPolygonsTouch, AgreesWithBoostOnHalfAMillionPairsOfAGrid) {
  Random random(11);
  int touching = 0;
  int degenerate = 0;
  for (int i = 0; i < 500'000; ++i) {
    const double pitch_m = i % 2 == 0 ? 0.5 : 0.25;
    const std::vector<Vec2> a = random_hull(random, pitch_m);
    const std::vector<Vec2> b = random_hull(random, pitch_m);
    const bool expected = boost_intersects(a, b);
    ASSERT_EQ(convex_polygons_touch(a, b), expected) << "pair " << i;
    touching += expected;
    degenerate += a.size() < 3 || b.size() < 3;
  }
  EXPECT_GT(touching, 100'000);
  EXPECT_GT(degenerate, 100'000);
}

TEST(ConvexPolygonsTouch, AgreesWithBoostOnHalfAMillionPairsAnywhere) {
  Random random(12);
  for (int i = 0; i < 500'000; ++i) {
    const std::vector<Vec2> a = random_hull(random, 0);
    const std::vector<Vec2> b = random_hull(random, 0);
    ASSERT_EQ(convex_polygons_touch(a, b), boost_intersects(a, b)) << "pair " << i;
  }
}

// At a pitch of 0.1 m coordinates are rounded, and what looks collinear is so only nearly. Here
// exact arithmetic is the judge; Boost works with tolerances and may differ.
TEST(ConvexPolygonsTouch, IsExactWhereCoordinatesAreRounded) {
  Random random(13);
  int boost_differs = 0;
  constexpr int kPairs = 200'000;
  for (int i = 0; i < kPairs; ++i) {
    const std::vector<Vec2> a = random_hull(random, 0.1);
    const std::vector<Vec2> b = random_hull(random, 0.1);
    ASSERT_EQ(convex_polygons_touch(a, b), touch_exactly(a, b)) << "pair " << i;
    boost_differs += touch_exactly(a, b) != boost_intersects(a, b);
  }
  RecordProperty("pairs_on_which_boost_differs", boost_differs);
  EXPECT_LT(boost_differs, kPairs / 100);
}

TEST(ConvexPolygonsTouch, CountsACommonCornerAndACommonEdge) {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(convex_polygons_touch(square, std::vector<Vec2>{{1, 1}}));
  EXPECT_TRUE(convex_polygons_touch(square, std::vector<Vec2>{{1, 1}, {2, 1}, {2, 2}}));
  EXPECT_TRUE(convex_polygons_touch(square, std::vector<Vec2>{{1, 0.25}, {2, 0}, {1, 0.75}}));
  EXPECT_TRUE(convex_polygons_touch(square, std::vector<Vec2>{{0.5, 0.5}}));
  EXPECT_FALSE(convex_polygons_touch(square, std::vector<Vec2>{{1.0000001, 0.5}}));
  const std::vector<Vec2> left{{0, 0}, {1, 1}};
  EXPECT_FALSE(convex_polygons_touch(left, std::vector<Vec2>{{2, 2}, {3, 3}}));
  EXPECT_TRUE(convex_polygons_touch(left, std::vector<Vec2>{{1, 1}, {3, 3}}));
}

}  // namespace
}  // namespace voronaut
