#include "voronaut/environments/shapes/shapes.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

using testing::HasSubstr;

// A plus sign: twelve corners, four of them reflex.
Polygon plus() {
  return {{{1, -3},
           {1, -1},
           {3, -1},
           {3, 1},
           {1, 1},
           {1, 3},
           {-1, 3},
           {-1, 1},
           {-3, 1},
           {-3, -1},
           {-1, -1},
           {-1, -3}}};
}

std::string rejection(const Shapes& shapes) {
  try {
    validated(shapes);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Shapes, SignedDistanceIsNegativeInsideSolids) {
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(3, 4), Circle{Vec2(0, 0), 2}), 3);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(0, 0.5), Circle{Vec2(0, 0), 2}), -1.5);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(0, 0), plus()), -std::sqrt(2));
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(0, 2.5), plus()), -0.5);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(2, 2), plus()), 1);
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(4, 2), plus()), std::sqrt(2));
  EXPECT_DOUBLE_EQ(signed_distance(Vec2(3, 0), plus()), 0);
}

TEST(Shapes, ClearanceIsThatOfTheNearestShape) {
  Shapes shapes;
  EXPECT_EQ(clearance_m(shapes, Vec2(0, 0)), std::numeric_limits<double>::infinity());
  shapes.circles = {{Vec2(5, 0), 1}};
  EXPECT_DOUBLE_EQ(clearance_m(shapes, Vec2(0, 0)), 4);
  shapes.segments = {{Vec2(-2, -1), Vec2(-2, 1)}};
  EXPECT_DOUBLE_EQ(clearance_m(shapes, Vec2(0, 0)), 2);
  shapes.polygons = {box(Vec2(0, 0), 1, 0.5)};
  EXPECT_DOUBLE_EQ(clearance_m(shapes, Vec2(0, 0)), -0.25);
}

TEST(Shapes, WindingNumberAgreesOnWhatIsInside) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random rng(seed);
    const Polygon polygon = random_polygon(rng, Vec2(0.2, -0.1), 2);
    for (int i = 0; i < 50; ++i) {
      const Vec2 p = random_point(rng, 2);
      double turned_rad = 0;
      for (std::size_t k = 0; k < polygon.vertices.size(); ++k) {
        const Vec2 a = edge(polygon, k).a - p;
        const Vec2 b = edge(polygon, k).b - p;
        turned_rad += std::atan2(cross(a, b), a.dot(b));
      }
      EXPECT_EQ(encloses(polygon, p), std::abs(turned_rad) > 3) << "seed " << seed;
    }
  }
}

TEST(Shapes, SegmentsMeetOrAreApartByTheirClosestPoints) {
  const Segment s{Vec2(0, 0), Vec2(4, 0)};
  EXPECT_EQ(distance(s, {Vec2(2, -1), Vec2(2, 1)}), 0);
  EXPECT_EQ(distance(s, {Vec2(4, 0), Vec2(5, 3)}), 0);
  EXPECT_EQ(distance(s, {Vec2(1, 0), Vec2(2, 0)}), 0);
  EXPECT_DOUBLE_EQ(distance(s, {Vec2(5, 0), Vec2(7, 0)}), 1);
  EXPECT_DOUBLE_EQ(distance(s, {Vec2(2, 1), Vec2(2, 5)}), 1);
  EXPECT_DOUBLE_EQ(distance(s, {Vec2(7, 4), Vec2(9, 4)}), 5);
}

TEST(Shapes, BoxesTurnWithTheirHeading) {
  const Polygon lying = box(Vec2(1, 2), 4, 2);
  EXPECT_EQ(lying.vertices.front(), Vec2(-1, 1));
  EXPECT_EQ(bounds_of(lying).max, Vec2(3, 3));
  const Polygon standing = box(Vec2(1, 2), 4, 2, Vec2(0, 1));
  EXPECT_EQ(bounds_of(standing).min, Vec2(0, 0));
  EXPECT_EQ(bounds_of(standing).max, Vec2(2, 4));
  EXPECT_EQ(box(Bounds{Vec2(0, 0), Vec2(2, 4)}).vertices.size(), 4U);
}

TEST(Shapes, ValidatedMakesPolygonsCounterClockwise) {
  Shapes shapes;
  shapes.polygons = {{{{0, 0}, {0, 1}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}, plus()};
  const Shapes good = validated(shapes);
  EXPECT_EQ(good.polygons[0].vertices, (std::vector<Vec2>{{1, 1}, {0, 1}, {0, 0}}));
  EXPECT_EQ(good.polygons[1].vertices, shapes.polygons[1].vertices);
  EXPECT_EQ(good.polygons[2].vertices, plus().vertices);
}

TEST(Shapes, ValidatedNamesWhatIsWrong) {
  const double nan = std::nan("");
  const double inf = std::numeric_limits<double>::infinity();
  const Circle good{Vec2(0, 0), 1};
  const auto circle = [&](const Circle& c) { return rejection({{good, c}, {}, {}}); };
  EXPECT_EQ(circle({Vec2(5, 5), 0.1}), "accepted");
  EXPECT_THAT(circle({Vec2(0, nan), 1}), HasSubstr("circle 1 has a coordinate"));
  EXPECT_THAT(circle({Vec2(0, 0), 0}), HasSubstr("circle 1 has a radius"));
  EXPECT_THAT(circle({Vec2(0, 0), -1}), HasSubstr("circle 1 has a radius"));
  EXPECT_THAT(circle({Vec2(0, 0), nan}), HasSubstr("circle 1 has a radius"));
  EXPECT_THAT(circle({Vec2(0, 0), inf}), HasSubstr("circle 1 has a radius"));
  EXPECT_THAT(rejection({{}, {{Vec2(0, 0), Vec2(inf, 0)}}, {}}), HasSubstr("segment 0 has"));
  EXPECT_EQ(rejection({{}, {{Vec2(1, 1), Vec2(1, 1)}}, {}}), "accepted");  // a post
  const auto polygon = [&](const std::vector<Vec2>& v) { return rejection({{}, {}, {{v}}}); };
  EXPECT_THAT(polygon({}), HasSubstr("polygon 0 has fewer than 3"));
  EXPECT_THAT(polygon({{0, 0}, {1, 0}}), HasSubstr("fewer than 3"));
  EXPECT_THAT(polygon({{0, 0}, {1, 0}, {1, nan}}), HasSubstr("coordinate"));
  EXPECT_THAT(polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), HasSubstr("repeats vertex 1"));
  EXPECT_THAT(polygon({{0, 0}, {1, 0}, {2, 0}}), HasSubstr("apex at (2, 0)"));
  EXPECT_THAT(polygon({{0, 0}, {4, 0}, {2, 0}, {2, 2}}),
              HasSubstr("has spikes. A spike point was found with apex at (4, 0)"));
  EXPECT_THAT(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
              HasSubstr("self-intersection point was found at (0.5, 0.5)"));
  // A corner that touches the opposite edge.
  EXPECT_THAT(polygon({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}),
              HasSubstr("self-intersection point was found at (2, 0)"));
}

}  // namespace
}  // namespace voronaut
