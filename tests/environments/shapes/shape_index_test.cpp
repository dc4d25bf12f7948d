#include "voronaut/environments/shapes/shape_index.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <malloc.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

// Clearance of a way, from the exact distances of shapes.h.
double way_clearance_m(const Shapes& shapes, const Segment& way) {
  double nearest_m = clearance_m(shapes, way.a);
  for (const Circle& c : shapes.circles) {
    nearest_m = std::min(nearest_m, distance(c.center, way) - c.radius_m);
  }
  for (const Segment& s : shapes.segments) nearest_m = std::min(nearest_m, distance(s, way));
  for (const Polygon& polygon : shapes.polygons) {
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      nearest_m = std::min(nearest_m, distance(edge(polygon, i), way));
    }
  }
  return nearest_m;
}

TEST(ShapeIndex, ClearanceIsThatOfAllShapes) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random rng(seed);
    const double size_m = rng.uniform(0.05, 3);
    const Shapes shapes = random_shapes(rng, 1 + static_cast<int>(rng.below(30)), 10, size_m);
    const ShapeIndex index(shapes, seed % 3 == 0 ? rng.uniform(0.2, 20) : 0);
    for (int i = 0; i < 100; ++i) {
      const Vec2 p = random_point(rng, i % 5 == 0 ? 40 : 11);
      const double exact_m = clearance_m(shapes, p);
      EXPECT_NEAR(index.clearance_m(p), exact_m, 1e-12);
      const double within_m = rng.uniform(0, 5);
      EXPECT_NEAR(index.clearance_m(p, within_m), std::min(exact_m, within_m), 1e-12);
      bool inside = false;
      for (const Polygon& polygon : shapes.polygons) inside = inside || encloses(polygon, p);
      EXPECT_EQ(index.is_inside_polygon(p), inside);
    }
    if (HasFailure()) return;
  }
}

TEST(ShapeIndex, WithoutShapesIsFreeEverywhere) {
  // The corner of the grid without cells, too: rays there enter and leave it at once.
  const ShapeIndex none(Shapes{});
  const auto never = [](std::uint32_t) { ADD_FAILURE() << "no shape is there"; };
  for (const Vec2& p : {Vec2(0, 0), Vec2(0, -3), Vec2(2, 0), Vec2(-1, -1)}) {
    SCOPED_TRACE(testing::Message() << p.transpose());
    EXPECT_EQ(none.clearance_m(p), std::numeric_limits<double>::infinity());
    EXPECT_EQ(none.clearance_m(p, 2), 2);
    EXPECT_FALSE(none.is_inside_polygon(p));
    for (const Vec2& direction : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0.6, 0.8)}) {
      EXPECT_TRUE(none.segment_is_clear(p, p + 5 * direction, 0.3));
      none.walk(p, direction, 5, never, never, [](double) { return false; });
    }
    none.visit({p - Vec2(1, 1), p + Vec2(1, 1)}, never, never);
  }
}

// What the heap holds in all.
std::size_t held_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

std::size_t bytes_of(const Shapes& shapes) {
  const std::size_t before = held_bytes();
  const ShapeIndex index(shapes);
  return held_bytes() - before;
}

Shapes circles_over_each_other(int count, double side_m) {
  Random rng(7);
  Shapes shapes;
  for (int i = 0; i < count; ++i) {
    const double x_m = rng.uniform(0, side_m);
    shapes.circles.push_back({{x_m, rng.uniform(0, side_m)}, 0.5});
  }
  return shapes;
}

TEST(ShapeIndex, TakesMemoryInProportionWhereCirclesLieOverEachOther) {
  if (bytes_of(circles_over_each_other(100, 1)) == 0) GTEST_SKIP() << "another heap counts";
  for (const double side_m : {0.0, 0.1, 5.0}) {
    SCOPED_TRACE(side_m);
    const std::size_t few = bytes_of(circles_over_each_other(20'000, side_m));
    EXPECT_LT(few, 20'000 * 200U);
    EXPECT_LT(bytes_of(circles_over_each_other(200'000, side_m)), 12 * few + 20'000);
  }
}

TEST(ShapeIndex, HoldsOneOfEqualCircles) {
  Shapes shapes;
  for (const double x : {3.0, 1.0, 3.0, 2.0, 1.0}) shapes.circles.push_back({{x, 1}, 0.5});
  shapes.circles.push_back({{2, 1}, 0.25});
  std::vector<double> x_m;
  const ShapeIndex index(shapes);
  for (const Circle& circle : index.circles()) x_m.push_back(circle.center.x());
  EXPECT_EQ(x_m, (std::vector<double>{3, 1, 2, 2}));
}

TEST(ShapeIndex, SweptDiscIsExact) {
  int clear = 0;
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random rng(seed);
    const Shapes shapes = random_shapes(rng, 1 + static_cast<int>(rng.below(10)), 10, 0.7);
    const ShapeIndex index(shapes, seed % 3 == 0 ? rng.uniform(0.2, 20) : 0);
    for (int i = 0; i < 100; ++i) {
      Segment way{random_point(rng, 12), {}};
      way.b = way.a + rng.uniform(0, 5) * random_direction(rng);
      if (i % 10 == 0) way.b = Vec2(way.a.x(), way.b.y());
      if (i % 10 == 1) way.b = Vec2(way.b.x(), way.a.y());
      if (i % 10 == 2) way.b = way.a;
      const double exact_m = way_clearance_m(shapes, way);
      const double radius_m = rng.uniform(0.01, 1.5);
      const bool expected = exact_m >= radius_m;
      EXPECT_EQ(index.segment_is_clear(way.a, way.b, radius_m), expected);
      (expected ? clear : blocked)++;
      // A hair to either side of contact.
      if (exact_m > 0.001) {
        EXPECT_TRUE(index.segment_is_clear(way.a, way.b, exact_m - 1e-9));
        EXPECT_FALSE(index.segment_is_clear(way.a, way.b, exact_m + 1e-9));
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(clear, 3000);
  EXPECT_GT(blocked, 3000);
}

TEST(ShapeIndex, ThinWallsAreNotTunnelled) {
  Shapes shapes;
  shapes.segments = {{Vec2(0, -1), Vec2(0, 1)}};
  const ShapeIndex index(shapes);
  EXPECT_FALSE(index.segment_is_clear(Vec2(-50, 0), Vec2(50, 0.1), 1e-9));
  EXPECT_TRUE(index.segment_is_clear(Vec2(-50, 1.5), Vec2(50, 1.5), 0.5));
  EXPECT_FALSE(index.segment_is_clear(Vec2(-50, 1.5), Vec2(50, 1.5), 0.501));
}

TEST(ShapeIndex, WayInsideASolidIsBlocked) {
  Shapes shapes;
  shapes.polygons = {box(Vec2(0, 0), 100, 100)};
  shapes.circles = {{Vec2(200, 0), 50}};
  const ShapeIndex index(shapes, 1);
  EXPECT_FALSE(index.segment_is_clear(Vec2(0, 0), Vec2(1, 0), 0.1));
  EXPECT_FALSE(index.segment_is_clear(Vec2(200, 0), Vec2(201, 0), 0.1));
  EXPECT_TRUE(index.segment_is_clear(Vec2(100, 0), Vec2(101, 0), 0.1));
}

TEST(ShapeIndex, VisitsEveryPrimitiveThatReachesIntoTheArea) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random rng(seed);
    const Shapes shapes = random_shapes(rng, 20, 10, 0.8);
    const ShapeIndex index(shapes);
    const Vec2 p = random_point(rng, 12);
    const double reach_m = rng.uniform(0, 4);
    std::vector<int> circles(index.circles().size());
    std::vector<int> edges(index.edges().size());
    index.visit(
        {p - Vec2::Constant(reach_m), p + Vec2::Constant(reach_m)},
        [&](std::uint32_t i) { ++circles[i]; }, [&](std::uint32_t i) { ++edges[i]; });
    for (std::size_t i = 0; i < circles.size(); ++i) {
      if (signed_distance(p, index.circles()[i]) <= reach_m) {
        EXPECT_GE(circles[i], 1) << "seed " << seed;
      }
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (distance(p, index.edges()[i]) <= reach_m) {
        EXPECT_GE(edges[i], 1) << "seed " << seed;
      }
    }
  }
}

TEST(ShapeIndex, ShapesInOnePointOrOnOneLineAreFound) {
  Shapes post;
  post.segments = {{Vec2(3, 4), Vec2(3, 4)}};
  EXPECT_DOUBLE_EQ(ShapeIndex(post).clearance_m(Vec2(0, 0)), 5);
  EXPECT_FALSE(ShapeIndex(post).segment_is_clear(Vec2(0, 4), Vec2(9, 4), 0.1));
  Shapes line;
  for (int i = 0; i < 100; ++i) line.segments.push_back({Vec2(i, 0), Vec2(i + 0.5, 0)});
  const ShapeIndex index(line);
  EXPECT_DOUBLE_EQ(index.clearance_m(Vec2(70.75, 0)), 0.25);
  EXPECT_TRUE(index.segment_is_clear(Vec2(70.75, -3), Vec2(70.75, 3), 0.25));
  EXPECT_FALSE(index.segment_is_clear(Vec2(70.75, -3), Vec2(70.75, 3), 0.251));
}

}  // namespace
}  // namespace voronaut
