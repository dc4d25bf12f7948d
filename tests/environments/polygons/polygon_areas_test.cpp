#include "voronaut/environments/polygons/polygon_areas.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

Polygon box_of(double x0, double y0, double x1, double y1) {
  return box(Bounds{{x0, y0}, {x1, y1}});
}

std::string reason(const PolygonArea& area) {
  try {
    oriented(area);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "valid";
}

const PolygonArea kFrame{{{0, 0}, {6, 0}, {6, 4}, {0, 4}}, {{{1, 1}, {2, 1}, {2, 3}, {1, 3}}}};

TEST(PolygonAreas, AreOriented) {
  const PolygonArea turned = oriented({{{0, 4}, {6, 4}, {6, 0}, {0, 0}}, kFrame.holes});
  EXPECT_EQ(turned.outer, (std::vector<Vec2>{{0, 0}, {6, 0}, {6, 4}, {0, 4}}));
  EXPECT_EQ(turned.holes, (std::vector<std::vector<Vec2>>{{{1, 3}, {2, 3}, {2, 1}, {1, 1}}}));
}

TEST(PolygonAreas, AreRefusedWithTheReason) {
  EXPECT_NE(reason({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}).find("self-intersections"),
            std::string::npos);
  EXPECT_NE(
      reason({kFrame.outer, {{{7, 1}, {8, 1}, {8, 2}}}}).find("interior rings defined outside"),
      std::string::npos);
}

TEST(PolygonAreas, LoseNoPlaceWithTheirHoles) {
  // Two holes, one beside and one above the other, and a notch.
  const PolygonArea area = oriented({{{0, 0}, {9, 0}, {9, 7}, {5, 6}, {0, 7}},
                                     {{{1, 1}, {2, 1}, {2, 3}, {1, 3}},
                                      {{1.5, 4}, {6, 4}, {4, 5.25}},
                                      {{7, 1}, {8, 2}, {7, 3}, {6.1, 2}}}});
  Shapes shapes;
  shapes.polygons = without_holes(area);
  EXPECT_GE(shapes.polygons.size(), 4U);
  const World world({{-1, -1}, {10, 8}}, shapes);  // says which is not simple
  for (double x = -0.95; x < 10; x += 0.1) {
    for (double y = -0.97; y < 8; y += 0.1) {
      const Vec2 p(x, y);
      bool inside = encloses({area.outer}, p);
      for (const auto& hole : area.holes) inside = inside && !encloses({hole}, p);
      ASSERT_EQ(world.clearance_m(p) < 0, inside) << x << ", " << y;
    }
  }
  // Nothing slips through where they were cut, at any height.
  for (double y = 0.01; y < 6; y += 0.013)
    EXPECT_FALSE(world.segment_is_clear({-0.5, y}, {9.5, y + 1e-4}, 1e-9)) << y;
}

TEST(PolygonAreas, AreOneWhereTheyOverlapOrShareAnEdge) {
  const auto row = united({box_of(0, 0, 1, 1), box_of(1, 0, 2, 1), box_of(1.5, 0.5, 3, 2)});
  ASSERT_EQ(row.size(), 1U);
  EXPECT_TRUE(row[0].holes.empty());
  EXPECT_EQ(row[0].outer.size(), 8U);
  const auto ring =
      united({box_of(0, 0, 3, 1), box_of(0, 2, 3, 3), box_of(0, 0, 1, 3), box_of(2, 0, 3, 3)});
  ASSERT_EQ(ring.size(), 1U);
  ASSERT_EQ(ring[0].holes.size(), 1U);
  EXPECT_EQ(ring[0].holes[0].size(), 4U);
  EXPECT_EQ(united({box_of(0, 0, 1, 1), box_of(1, 1, 2, 2), box_of(5, 0, 6, 1)}).size(), 3U);
  EXPECT_TRUE(united({}).empty());
}

TEST(FreeShare, CountsWhatIsCoveredOnceAndWithinTheBounds) {
  Shapes shapes;
  const Bounds bounds{{0, 0}, {10, 5}};
  EXPECT_EQ(free_share(bounds, shapes), 1);
  shapes.polygons = {box_of(-3, 0, 2, 5), box_of(1, 0, 2, 5)};
  EXPECT_NEAR(free_share(bounds, shapes), 0.8, 1e-9);
  shapes.circles = {{{7, 2.5}, 1}, {{1, 1}, 0.5}};
  EXPECT_NEAR(free_share(bounds, shapes), 0.8 - std::numbers::pi / 50, 1e-4);
}

}  // namespace
}  // namespace voronaut
