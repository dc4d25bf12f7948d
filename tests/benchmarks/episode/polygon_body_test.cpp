#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/body_clearance.h"
#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"
#include "voronaut/benchmarks/episode/referee.h"
#include "voronaut/environments/shapes/convex_distance.h"
#include "voronaut/tests/environments/shapes/random_shapes.h"

// Polygons as the referee and the metrics judge them.
namespace voronaut {
namespace {

// FCL's answers come from an iterative method: closer to the surface than this they may fall either
// way.
constexpr double kBand_m = 1e-5;

VehicleSpec with_corners(std::vector<Vec2> corners) {
  VehicleSpec vehicle;
  vehicle.body_radius_m = circumscribed_radius_m(corners);
  vehicle.footprint.corners_body = std::move(corners);
  return vehicle;
}

VehicleSpec rectangle() { return with_corners(box(Vec2(0.05, 0), 0.5, 0.3).vertices); }

// Around the origin, which need not be its middle.
VehicleSpec random_body(Random& rng) {
  const int corners = 3 + static_cast<int>(rng.below(6));
  const Vec2 ahead = rng.uniform(0.1, 0.6) * random_direction(rng);
  const Vec2 left = rng.uniform(0.3, 1) * left_of(ahead);
  const Vec2 middle = rng.uniform(0, 0.2) * ahead;
  std::vector<Vec2> convex;
  for (int i = 0; i < corners; ++i) {
    const auto turn = Sleef_cinz_sincosd1_u10purec(2 * std::numbers::pi * i / corners);
    convex.push_back(middle + turn.y * ahead + turn.x * left);
  }
  return with_corners(convex);
}

// A million poses take some ten seconds: worlds and poses in the comparison of every day are a
// twentieth of that (--gtest_repeat=20 --gtest_shuffle gives other seeds, all of them a million).
TEST(PolygonBody, IsJudgedByFclAsByExactDistances) {
  int compared = 0, touching = 0, turned_matters = 0;
  const int first = 1 + 100 * (::testing::UnitTest::GetInstance()->random_seed() % 1000);
  for (int seed = first; seed < first + 50; ++seed) {
    Random rng(static_cast<std::uint64_t>(seed));
    const Shapes shapes = random_shapes(rng, 5, 5, 0.6);
    const ShapeIndex index(shapes);
    const VehicleSpec body = random_body(rng);
    const GroundTruthCollisionChecker referee(shapes, body.body_radius_m, body.footprint);
    std::vector<Vec2> corners;
    for (int i = 0; i < 1000; ++i) {
      const Vec2 p = random_point(rng, 6), heading = random_direction(rng);
      if (index.clearance_m(p) < 0) continue;  // FCL asks the outlines of polygons alone
      place_corners(body.footprint.corners_body, p, heading, corners);
      const double kept_m = clearance_m(index, corners);
      // Who touches by less than the band keeps nothing, who keeps less than it may touch.
      if (kept_m > 0 && kept_m < kBand_m) continue;
      if (kept_m == 0 && !referee.touches(p, heading)) {
        for (Vec2& corner : corners) corner = p + (1 - 2 * kBand_m / 0.1) * (corner - p);
        ASSERT_GT(clearance_m(index, corners), 0) << "seed " << seed << " at " << p.transpose();
        continue;
      }
      ASSERT_EQ(referee.touches(p, heading), kept_m == 0)
          << "seed " << seed << " at " << p.transpose() << " keeps " << kept_m;
      ++compared;
      touching += kept_m == 0;
      turned_matters += (kept_m == 0) != (index.clearance_m(p) < body.body_radius_m);
    }
  }
  EXPECT_GT(compared, 40'000);
  EXPECT_GT(touching, 2'000);
  EXPECT_GT(turned_matters, 1'000);
}

TEST(PolygonBody, TouchesWhatItsSideOrItsCornerReachesAndNothingShortOfIt) {
  const VehicleSpec body = rectangle();  // 0.3 m ahead, 0.2 m back, 0.15 m to either side
  const Shapes pillar{{{Vec2(1, 0), 0.5}}, {}, {}};
  const GroundTruthCollisionChecker beside(pillar, body.body_radius_m, body.footprint);
  const auto expect_touch_at = [&](const Vec2& p, const Vec2& heading) {
    EXPECT_TRUE(beside.touches(p + Vec2(kBand_m, 0), heading)) << p.transpose();
    EXPECT_FALSE(beside.touches(p - Vec2(kBand_m, 0), heading)) << p.transpose();
  };
  expect_touch_at(Vec2(0.2, 0), Vec2(1, 0));
  expect_touch_at(Vec2(0.3, 0), Vec2(-1, 0));
  expect_touch_at(Vec2(0.35, 0.1), Vec2(0, 1));
  const Shapes wall{{}, {{Vec2(1, -3), Vec2(1, 3)}}, {}};
  const GroundTruthCollisionChecker before_wall(wall, body.body_radius_m, body.footprint);
  const Vec2 slanted = Vec2(1, 1).normalized();
  const double reach_m = slanted.dot(Vec2(0.3, 0.15));
  EXPECT_TRUE(before_wall.touches(Vec2(1 - reach_m + kBand_m, 0), slanted));
  EXPECT_FALSE(before_wall.touches(Vec2(1 - reach_m - kBand_m, 0), slanted));
}

TEST(PolygonBody, IsJudgedByTheRefereeAsItIsTurned) {
  Scenario scenario;
  scenario.world = std::make_shared<World>(Bounds{Vec2(-5, -5), Vec2(5, 5)},
                                           Shapes{{}, {{Vec2(-5, 0.25), Vec2(5, 0.25)}}, {}});
  scenario.goal_world = Vec2(4, 0);
  scenario.cruise_height_m = 0;
  const auto outcome = [&](const Vec2& heading) {
    Referee referee(scenario, rectangle(), 4, {});
    EXPECT_FALSE(referee.contact_at_start());
    VehicleState state = make_model(UnicycleConfig{})->at_rest({1, 0, 0}, heading);
    referee.judge(1, state);
    return referee.verdict() ? referee.verdict()->outcome : Outcome::goal_reached;
  };
  EXPECT_EQ(outcome(Vec2(1, 0)), Outcome::goal_reached);
  EXPECT_EQ(outcome(Vec2(0, 1)), Outcome::collision);
}

VehicleState standing(const Vec2& p, const Vec2& heading) {
  return make_model(UnicycleConfig{})->at_rest({p.x(), p.y(), 0}, heading);
}

TEST(BodyClearance, IsTheLeastThatTheTurnedSurfaceKept) {
  const Shapes pillar{{{Vec2(1, 0), 0.5}}, {}, {}};
  const ShapeIndex index(pillar);
  BodyClearance of_polygon(index, rectangle());
  of_polygon.add(standing(Vec2(0, 0), Vec2(0, 1)), index.clearance_m(Vec2(0, 0)));
  EXPECT_NEAR(of_polygon.smallest_m(), 0.35, 1e-12);
  of_polygon.add(standing(Vec2(0, 0), Vec2(1, 0)), index.clearance_m(Vec2(0, 0)));
  EXPECT_NEAR(of_polygon.smallest_m(), 0.2, 1e-12);
  of_polygon.add(standing(Vec2(-1, 0), Vec2(1, 0)), index.clearance_m(Vec2(-1, 0)));
  EXPECT_NEAR(of_polygon.smallest_m(), 0.2, 1e-12);
  of_polygon.add(standing(Vec2(0.3, 0), Vec2(1, 0)), index.clearance_m(Vec2(0.3, 0)));
  EXPECT_EQ(of_polygon.smallest_m(), 0);

  VehicleSpec disc;
  disc.body_radius_m = 0.2;
  BodyClearance of_disc(index, disc);
  of_disc.add(standing(Vec2(0, 0), Vec2(0, 1)), index.clearance_m(Vec2(0, 0)));
  EXPECT_NEAR(of_disc.smallest_m(), 0.3, 1e-12);
}

}  // namespace
}  // namespace voronaut
