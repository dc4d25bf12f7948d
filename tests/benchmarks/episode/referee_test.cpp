#include "voronaut/benchmarks/episode/referee.h"

#include <gtest/gtest.h>

#include "voronaut/environments/random.h"

namespace voronaut {
namespace {

constexpr double kBodyRadius_m = 0.25;

Shapes mixed_shapes(Random& random) {
  Shapes shapes;
  const auto point = [&] { return Vec2(random.uniform(-5, 5), random.uniform(-5, 5)); };
  for (int i = 0; i < 6; ++i) shapes.circles.push_back({point(), random.uniform(0.05, 1)});
  for (int i = 0; i < 4; ++i) shapes.segments.push_back({point(), point()});
  for (int i = 0; i < 3; ++i) {
    const Vec2 corner = point();
    const Vec2 size(random.uniform(0.2, 2), random.uniform(0.2, 2));
    shapes.polygons.push_back(
        {{corner, corner + Vec2(size.x(), 0), corner + size, corner + Vec2(0, size.y())}});
  }
  return shapes;
}

// FCL's answers come from an iterative method: closer to the surface than this they may fall either
// way. Inside a polygon the outline alone is asked.
constexpr double kBand_m = 1e-5;

TEST(GroundTruthCollisionChecker, AgreesWithExactClearanceOutsideABandOfTenMicrometres) {
  int compared = 0;
  int touching = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Shapes shapes = mixed_shapes(random);
    const GroundTruthCollisionChecker oracle(shapes, kBodyRadius_m);
    const World world({Vec2(-10, -10), Vec2(10, 10)}, shapes);
    for (int i = 0; i < 500; ++i) {
      const Vec2 p(random.uniform(-6, 6), random.uniform(-6, 6));
      const double margin_m = world.clearance_m(p) - kBodyRadius_m;
      if (std::abs(margin_m) < kBand_m || margin_m < -2 * kBodyRadius_m) continue;
      if (margin_m < -kBodyRadius_m) continue;  // the centre is inside a solid
      ASSERT_EQ(oracle.touches(p), margin_m < 0) << "seed " << seed << " at " << p.transpose();
      ++compared;
      touching += margin_m < 0;
    }
  }
  EXPECT_GT(compared, 10'000);
  EXPECT_GT(touching, 1'000);
}

TEST(GroundTruthCollisionChecker, SeesACylinderJustTouchedAndNotOneJustMissed) {
  const Shapes pillar{{{Vec2(1, 0), 0.5}}, {}, {}};
  const GroundTruthCollisionChecker oracle(pillar, kBodyRadius_m);
  EXPECT_TRUE(oracle.touches(Vec2(0.25 + kBand_m, 0)));
  EXPECT_FALSE(oracle.touches(Vec2(0.25 - kBand_m, 0)));
}

// Along a way it looks around once and then not for a while.
TEST(GroundTruthCollisionChecker, SaysAlongAWayWhatItSaysOfEachPlace) {
  int touching = 0, changes = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const Shapes shapes = mixed_shapes(random);
    const auto scene = CollisionScene::of(shapes);
    const GroundTruthCollisionChecker along(scene, kBodyRadius_m);
    Vec2 p(random.uniform(-5, 5), random.uniform(-5, 5));
    Vec2 step(0.02, 0);
    bool before = false;
    for (int i = 0; i < 1500; ++i) {
      if (i % 40 == 0) step = random.uniform(0.005, 0.06) * Vec2(random.normal(), random.normal());
      if (i % 500 == 499) p = Vec2(random.uniform(-5, 5), random.uniform(-5, 5));
      if ((p + step).cwiseAbs().maxCoeff() > 6) step = -step;
      p += step;
      const bool touches = GroundTruthCollisionChecker(scene, kBodyRadius_m).touches(p);
      ASSERT_EQ(along.touches(p), touches) << "seed " << seed << " at " << p.transpose();
      touching += touches;
      changes += touches != before;
      before = touches;
    }
  }
  EXPECT_GT(touching, 1'000);
  EXPECT_GT(changes, 100);
}

VehicleSpec body() {
  VehicleSpec vehicle;
  vehicle.body_radius_m = kBodyRadius_m;
  return vehicle;
}

Scenario open_field() {
  Scenario scenario;
  scenario.name = "open";
  scenario.world = std::make_shared<World>(Bounds{Vec2(-1, -5), Vec2(12, 5)},
                                           Shapes{{{Vec2(5, 3), 0.5}}, {}, {}});
  scenario.start_world = Vec2(0, 0);
  scenario.goal_world = Vec2(10, 0);
  scenario.cruise_height_m = 1;
  return scenario;
}

VehicleState at(double x, double y, double z = 1) {
  VehicleState state;
  state.p_world = Vec3(x, y, z);
  return state;
}

TEST(Referee, NeedsASecondWithoutContactAfterArrival) {
  const Scenario scenario = open_field();
  Referee referee(scenario, body(), 10, {});
  referee.judge(5.0, at(9.9, 0));
  EXPECT_FALSE(referee.verdict());
  referee.judge(5.9, at(10.5, 0));
  EXPECT_FALSE(referee.verdict());
  referee.judge(6.0, at(10.1, 0));
  ASSERT_TRUE(referee.verdict());
  EXPECT_EQ(referee.verdict()->outcome, Outcome::goal_reached);
  EXPECT_DOUBLE_EQ(referee.end_s(), 5.0);
}

TEST(Referee, CallsAContactWhileBrakingACollision) {
  const Scenario scenario = open_field();
  Referee referee(scenario, body(), 10, {});
  referee.judge(5.0, at(9.9, 0));
  referee.judge(5.5, at(5, 2.5));
  ASSERT_TRUE(referee.verdict());
  EXPECT_EQ(referee.verdict()->outcome, Outcome::collision);
}

TEST(Referee, IgnoresTheGroundBelowHalfAMetre) {
  const Scenario scenario = open_field();
  Referee referee(scenario, body(), 10, {});
  referee.judge(1.0, at(5, 2.5, 0.49));
  EXPECT_FALSE(referee.verdict());
  referee.judge(1.01, at(5, 2.5, 0.5));
  EXPECT_TRUE(referee.verdict());
}

TEST(Referee, CallsStandingStillWhatStaysWithinTheRadiusAndNothingElse) {
  const Scenario scenario = open_field();
  const double radius_m = LoopConfig{}.stuck_radius_m;
  Referee pacing(scenario, body(), 10, {});
  Referee dithering(scenario, body(), 10, {});
  for (int i = 1; i <= 3; ++i) {
    pacing.judge(19.0 * i, at(1.01 * radius_m * (i % 2), 0));
    dithering.judge(19.0 * i, at(0.99 * radius_m * (i % 2), 0));
  }
  EXPECT_FALSE(pacing.verdict());
  ASSERT_TRUE(dithering.verdict());
  EXPECT_EQ(dithering.verdict()->outcome, Outcome::stuck);
}

TEST(Referee, KnowsTheBoundsTheClockAndStandingStill) {
  const Scenario scenario = open_field();
  Referee outside(scenario, body(), 10, {});
  outside.judge(1.0, at(-1.01, 0));
  EXPECT_EQ(outside.verdict()->outcome, Outcome::out_of_bounds);

  Referee waiting(scenario, body(), 10, {});
  waiting.judge(19.9, at(0, 0));
  EXPECT_FALSE(waiting.verdict());
  waiting.judge(20.0, at(0, 0));
  EXPECT_EQ(waiting.verdict()->outcome, Outcome::stuck);

  Referee circling(scenario, body(), 10, {});
  for (int i = 1; i < 14; ++i) circling.judge(10.0 * i, at(i % 2, 0));
  EXPECT_FALSE(circling.verdict());
  circling.judge(140.0, at(0, 1));
  EXPECT_EQ(circling.verdict()->outcome, Outcome::timeout);
}

}  // namespace
}  // namespace voronaut
