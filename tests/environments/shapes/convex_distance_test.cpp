#include "voronaut/environments/shapes/convex_distance.h"

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

// Corners of an affine image of a regular polygon, counter-clockwise.
std::vector<Vec2> random_convex(Random& rng, const Vec2& center) {
  const int corners = 3 + static_cast<int>(rng.below(6));
  const Vec2 ahead = rng.uniform(0.1, 1) * random_direction(rng);
  const Vec2 left = rng.uniform(0.2, 1) * left_of(ahead);
  std::vector<Vec2> convex;
  for (int i = 0; i < corners; ++i) {
    const auto turn = Sleef_cinz_sincosd1_u10purec(2 * std::numbers::pi * i / corners);
    convex.push_back(center + turn.y * ahead + turn.x * left);
  }
  return convex;
}

std::span<const Vec2> corners_of(const std::vector<Vec2>& convex) { return convex; }

TEST(ConvexDistance, IsThatOfAPolygonFromOutsideAndNothingInside) {
  Random rng(1);
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const std::vector<Vec2> convex = random_convex(rng, random_point(rng, 1));
    const Vec2 p = random_point(rng, 2);
    const double expected_m = std::max(0.0, signed_distance(p, Polygon{convex}));
    EXPECT_NEAR(distance(corners_of(convex), p), expected_m, 1e-12);
    EXPECT_NEAR(distance(corners_of(convex), Circle{p, 0.3}), std::max(0.0, expected_m - 0.3),
                1e-12);
    inside += expected_m == 0;
  }
  EXPECT_GT(inside, 100);
}

// Against the nearest of many points along the segment: never farther, and closer by no more than
// half their spacing.
TEST(ConvexDistance, OfASegmentIsThatOfItsNearestPoint) {
  Random rng(2);
  int touching = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Vec2> convex = random_convex(rng, random_point(rng, 1));
    const Segment s{random_point(rng, 2), random_point(rng, 2)};
    constexpr int kPoints = 400;
    double sampled_m = kInfinity;
    for (int k = 0; k <= kPoints; ++k)
      sampled_m = std::min(
          sampled_m,
          distance(corners_of(convex), Vec2(s.a + static_cast<double>(k) / kPoints * (s.b - s.a))));
    const double exact_m = distance(corners_of(convex), s);
    EXPECT_LE(exact_m, sampled_m + 1e-12);
    EXPECT_GE(exact_m, sampled_m - 0.5 * (s.b - s.a).norm() / kPoints - 1e-12);
    touching += exact_m == 0;
  }
  EXPECT_GT(touching, 100);
}

// A segment within, a body within a polygon of the world, a post within the body.
TEST(ConvexDistance, SeesWhatLiesInside) {
  const std::vector<Vec2> body = box(Vec2(0, 0), 2, 1).vertices;
  EXPECT_EQ(distance(corners_of(body), Segment{Vec2(-0.5, 0), Vec2(0.5, 0.1)}), 0);
  EXPECT_EQ(clearance_m(ShapeIndex(validated({{}, {}, {box(Vec2(0, 0), 20, 20)}})), body), 0);
  EXPECT_EQ(clearance_m(ShapeIndex(validated({{{Vec2(0.5, 0), 0.01}}, {}, {}})), body), 0);
}

TEST(ConvexDistance, FromManyShapesIsThatOfTheNearest) {
  Random rng(3);
  for (int world = 0; world < 40; ++world) {
    const Shapes shapes = random_shapes(rng, 6, 5, 0.6);
    const ShapeIndex index(shapes);
    for (int i = 0; i < 100; ++i) {
      const std::vector<Vec2> body = random_convex(rng, random_point(rng, 7));
      double expected_m = kInfinity;
      for (const Circle& circle : shapes.circles)
        expected_m = std::min(expected_m, distance(corners_of(body), circle));
      for (const Segment& wall : shapes.segments)
        expected_m = std::min(expected_m, distance(corners_of(body), wall));
      for (const Polygon& solid : shapes.polygons) {
        for (std::size_t k = 0; k < solid.vertices.size(); ++k)
          expected_m = std::min(expected_m, distance(corners_of(body), edge(solid, k)));
        if (encloses(solid, body.front())) expected_m = 0;
      }
      EXPECT_NEAR(clearance_m(index, body), expected_m, 1e-12);
      EXPECT_NEAR(clearance_m(index, body, 0.5), std::min(0.5, expected_m), 1e-12);
    }
  }
}

}  // namespace
}  // namespace voronaut
