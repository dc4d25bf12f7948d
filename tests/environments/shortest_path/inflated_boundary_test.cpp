#include "voronaut/environments/shortest_path/inflated_boundary.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/tests/environments/shapes/random_shapes.h"

namespace voronaut {
namespace {

constexpr double kTolerance = 1e-9;
const Bounds kBounds{Vec2(-10, -10), Vec2(10, 10)};

std::vector<FreeArc> arcs_around(const Vec2& center, InflatedBoundary& rims) {
  std::vector<FreeArc> arcs;
  for (std::uint32_t i = 0; i < rims.discs().size(); ++i) {
    if (rims.discs()[i].center != center) continue;
    const InflatedBoundary::ArcRange range = rims.arcs_of(i);
    for (std::uint32_t k = range.begin; k < range.end; ++k) arcs.push_back(rims.arc(k));
  }
  return arcs;
}

TEST(QuarterTurns, GrowCounterClockwiseAndComeBackAsDirections) {
  double last = -1;
  for (int i = 0; i < 3600; ++i) {
    const double angle_rad = 2 * std::numbers::pi * (i + 0.001) / 3600;
    const Vec2 d(std::cos(angle_rad), std::sin(angle_rad));
    const double quarters = quarter_turns(d);
    EXPECT_GT(quarters, last);
    EXPECT_LT(quarters, 4);
    EXPECT_LT((direction_at(quarters) - d).norm(), 1e-14);
    EXPECT_LT((direction_at(quarters - 8) - d).norm(), 1e-14);
    EXPECT_NEAR(quarters_ahead(quarters, quarter_turns(left_of(d))), 1, 1e-14);
    last = quarters;
  }
  EXPECT_EQ(quarter_turns(Vec2(1, 0)), 0);
  EXPECT_EQ(quarter_turns(Vec2(0, 2)), 1);
  EXPECT_EQ(quarter_turns(Vec2(-3, 0)), 2);
  EXPECT_EQ(quarter_turns(Vec2(0, -1)), 3);
}

TEST(CommonTangent, TouchesBothDiscsOnTheSidesOfTheirTurns) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random rng(seed);
    const Disc a{random_point(rng, 5), rng.uniform(0, 2)};
    const Disc b{random_point(rng, 5), rng.uniform(0, 2)};
    for (const int from : {1, -1}) {
      for (const int to : {1, -1}) {
        CommonTangent t;
        const double reach_m =
            from == to ? std::abs(a.radius_m - b.radius_m) : a.radius_m + b.radius_m;
        const bool exists = common_tangent(a, from, b, to, kTolerance, t);
        EXPECT_EQ(exists, (a.center - b.center).norm() >= reach_m) << "seed " << seed;
        if (!exists) continue;
        const Vec2 p = a.center + a.radius_m * t.depart;
        const Vec2 q = b.center + b.radius_m * t.arrive;
        EXPECT_NEAR((q - p).norm(), t.length_m, 1e-12);
        const Vec2 along = (q - p) / t.length_m;
        EXPECT_NEAR(cross(along, a.center - p), from * a.radius_m, 1e-9) << "seed " << seed;
        EXPECT_NEAR(cross(along, b.center - q), to * b.radius_m, 1e-9) << "seed " << seed;
      }
    }
  }
}

TEST(CommonTangent, HasNoLengthWhereDiscsTouchWithinTheTolerance) {
  for (const double gap_m : {1e-12, 0.0, -1e-12}) {
    CommonTangent t;
    ASSERT_TRUE(common_tangent({Vec2(0, 0), 1}, 1, {Vec2(3 + gap_m, 0), 2}, -1, kTolerance, t));
    EXPECT_NEAR(t.length_m, 0, 1e-5);
    EXPECT_NEAR((t.depart - Vec2(1, 0)).norm(), 0, 1e-5);
    ASSERT_TRUE(common_tangent({Vec2(1 + gap_m, 0), 0}, 1, {Vec2(0, 0), 1}, 1, kTolerance, t));
    EXPECT_NEAR((t.arrive - Vec2(1, 0)).norm(), 0, 1e-5);
  }
  CommonTangent t;
  EXPECT_FALSE(common_tangent({Vec2(0, 0), 1}, 1, {Vec2(3 - 1e-6, 0), 2}, -1, kTolerance, t));
}

TEST(TurnedRad, IsTheAngleInTheSenseOfTheTurnAndItsBoundIsBelow) {
  EXPECT_NEAR(turned_rad(Vec2(1, 0), Vec2(0, 1), 1), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(turned_rad(Vec2(1, 0), Vec2(0, 1), -1), 1.5 * std::numbers::pi, 1e-15);
  EXPECT_EQ(turned_rad(Vec2(1, 0), Vec2(1, -1e-10), 1), 0);
  Random rng(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 a = random_direction(rng);
    const Vec2 b = random_direction(rng);
    for (const int turn : {1, -1}) {
      EXPECT_LE(turned_at_least_rad(a, b, turn), turned_rad(a, b, turn) + 1e-15);
      EXPECT_GE(turned_at_least_rad(a, b, turn), 0.49 * turned_rad(a, b, turn));
    }
  }
}

TEST(InflatedBoundary, RimOfALoneCircleIsWhole) {
  Shapes shapes;
  shapes.circles = {{Vec2(0, 0), 1}};
  const World world(kBounds, shapes);
  InflatedBoundary rims(world, 0.5, kTolerance);
  const auto arcs = arcs_around(Vec2(0, 0), rims);
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_TRUE(arcs[0].whole());
  EXPECT_EQ(rims.discs()[0].radius_m, 1.5);
}

TEST(InflatedBoundary, CornerOfABoxIsFreeBetweenTheNormalsOfItsSides) {
  Shapes shapes;
  shapes.polygons = {box(Vec2(0, 0), 4, 2)};
  const World world(kBounds, shapes);
  InflatedBoundary rims(world, 0.5, kTolerance);
  EXPECT_EQ(rims.discs().size(), 4U);
  const auto arcs = arcs_around(Vec2(2, 1), rims);
  ASSERT_EQ(arcs.size(), 1U);
  EXPECT_NEAR(arcs[0].from_quarters, 0, 1e-12);
  EXPECT_NEAR(arcs[0].span_quarters, 1, 1e-12);
}

TEST(InflatedBoundary, JointsAndInnerCornersHaveNoFreeArc) {
  Shapes shapes;
  shapes.polygons = {box(Bounds{Vec2(0, 0), Vec2(1, 1)}), box(Bounds{Vec2(1, 0), Vec2(2, 1)}),
                     box(Bounds{Vec2(0, 1), Vec2(1, 2)})};
  const World world(kBounds, shapes);
  InflatedBoundary rims(world, 0.3, kTolerance);
  EXPECT_TRUE(arcs_around(Vec2(1, 0), rims).empty());
  EXPECT_TRUE(arcs_around(Vec2(1, 1), rims).empty());
  EXPECT_TRUE(arcs_around(Vec2(0, 1), rims).empty());
  EXPECT_EQ(arcs_around(Vec2(0, 0), rims).size(), 1U);
  EXPECT_EQ(arcs_around(Vec2(1, 2), rims).size(), 1U);
}

TEST(InflatedBoundary, ArcsAreFreeWhereTheDiscFitsAndNowhereElse) {
  int free_points = 0;
  int blocked_points = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random rng(seed);
    const double radius_m = rng.uniform(0.1, 0.6);
    const World world({Vec2(-3, -3), Vec2(3, 3)}, random_shapes(rng, 8, 3.5, 0.7));
    InflatedBoundary rims(world, radius_m, kTolerance);
    for (std::uint32_t i = 0; i < rims.discs().size(); ++i) {
      const Disc disc = rims.discs()[i];
      const InflatedBoundary::ArcRange range = rims.arcs_of(i);
      for (int k = 0; k < 50; ++k) {
        const Vec2 direction = random_direction(rng);
        bool on_arc = false;
        for (std::uint32_t a = range.begin; a < range.end; ++a) {
          on_arc = on_arc || rims.arc(a).position(quarter_turns(direction)) >= 0;
        }
        const Vec2 p = disc.center + disc.radius_m * direction;
        // On the rim itself the clearance is the radius; what is less by no more than the tolerance
        // may be given either way.
        const double share = world.clearance_m(p) / radius_m;
        if (share > 1 - 2 * kTolerance && share < 1 - 1e-12) continue;
        const bool fits = world.bounds().contains(p) && share > 1 - kTolerance;
        EXPECT_EQ(on_arc, fits);
        (fits ? free_points : blocked_points)++;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(free_points, 5000);
  EXPECT_GT(blocked_points, 5000);
}

}  // namespace
}  // namespace voronaut
