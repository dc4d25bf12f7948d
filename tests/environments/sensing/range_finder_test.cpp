#include "voronaut/environments/sensing/range_finder.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voronaut {
namespace {

const Bounds kBounds{Vec2(-50, -50), Vec2(50, 50)};

World wall_ahead() {
  Shapes shapes;
  shapes.segments = {{Vec2(2, -40), Vec2(2, 40)}};
  return {kBounds, shapes};
}

TEST(RangeFinder, HitsTheNearestOfTwoCircles) {
  Shapes shapes;
  shapes.circles = {{Vec2(2.2, 0), 0.5}, {Vec2(1.5, 0), 0.25}};
  const World world(kBounds, shapes);
  RangeFinderConfig config;
  config.rays = 3;
  Random rng(1);
  Scan scan;
  RangeFinder(config).sense(world, {}, 0.25, rng, scan);
  EXPECT_EQ(scan.stamp_s, 0.25);
  EXPECT_EQ(scan.max_range_m, 2.5);
  EXPECT_EQ(scan.range_m, (std::vector<double>{2.5, 1.25, 2.5}));
  EXPECT_FALSE(scan.is_return(0));
  EXPECT_TRUE(scan.is_return(1));
}

TEST(RangeFinder, ReusesTheMemoryOfTheScan) {
  const RangeFinder finder{RangeFinderConfig{}};
  Random rng(1);
  Scan scan;
  finder.sense(wall_ahead(), {}, 0, rng, scan);
  const double* memory = scan.range_m.data();
  const BeamFan* beams = scan.beams.get();
  finder.sense(wall_ahead(), {Vec2(1, 0), Vec2(0, 1)}, 1, rng, scan);
  EXPECT_EQ(scan.range_m.data(), memory);
  EXPECT_EQ(scan.beams.get(), beams);
  EXPECT_EQ(scan.sensor_world.p_world, Vec2(1, 0));
}

TEST(RangeFinder, WithoutNoiseDrawsNoRandomNumber) {
  Random used(5);
  Random fresh(5);
  Scan scan;
  RangeFinder(RangeFinderConfig{}).sense(wall_ahead(), {}, 0, used, scan);
  EXPECT_EQ(used.next(), fresh.next());
}

TEST(RangeFinder, NoiseHasTheStatedSpreadAndStaysInRange) {
  RangeFinderConfig config;
  config.rays = 20'000;
  config.field_of_view_rad = 0;
  config.noise_sigma_m = 0.03;
  Random rng(11);
  Scan scan;
  RangeFinder(config).sense(wall_ahead(), {}, 0, rng, scan);
  double sum = 0;
  double sum_sq = 0;
  for (const double r : scan.range_m) {
    sum += r - 2;
    sum_sq += (r - 2) * (r - 2);
  }
  EXPECT_NEAR(sum / 20'000, 0, 4 * 0.03 / std::sqrt(20'000));
  EXPECT_NEAR(std::sqrt(sum_sq / 20'000), 0.03, 0.001);

  config.noise_sigma_m = 2;
  RangeFinder(config).sense(wall_ahead(), {}, 0, rng, scan);
  EXPECT_THAT(scan.range_m, testing::Each(testing::AllOf(testing::Ge(0), testing::Le(2.5))));
  EXPECT_THAT(scan.range_m, testing::Contains(0.0));
  EXPECT_THAT(scan.range_m, testing::Contains(2.5));
}

TEST(RangeFinder, NoiseLeavesMissesAlone) {
  RangeFinderConfig config;
  config.noise_sigma_m = 0.1;
  Random rng(11);
  Scan scan;
  RangeFinder(config).sense(World(kBounds, {}), {}, 0, rng, scan);
  EXPECT_THAT(scan.range_m, testing::Each(2.5));
}

TEST(RangeFinder, DropsBeamsAtTheStatedRate) {
  RangeFinderConfig config;
  config.rays = 20'000;
  config.dropout_probability = 0.2;
  Random rng(3);
  Scan scan;
  RangeFinder(config).sense(wall_ahead(), {}, 0, rng, scan);
  int dropped = 0;
  for (const double r : scan.range_m) dropped += std::isnan(r);
  EXPECT_NEAR(dropped, 4000, 4 * std::sqrt(20'000 * 0.2 * 0.8));
}

TEST(RangeFinder, SameSeedGivesTheSameScan) {
  RangeFinderConfig config;
  config.noise_sigma_m = 0.02;
  config.dropout_probability = 0.1;
  const RangeFinder finder(config);
  Random rng_a(9);
  Random rng_b(9);
  Scan a;
  Scan b;
  finder.sense(wall_ahead(), {}, 0, rng_a, a);
  finder.sense(wall_ahead(), {}, 0, rng_b, b);
  EXPECT_THAT(a.range_m, testing::Pointwise(testing::NanSensitiveDoubleEq(), b.range_m));
}

TEST(RangeFinder, RefusesValuesOutOfBounds) {
  RangeFinderConfig config;
  config.rays = 0;
  try {
    RangeFinder finder(config);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(), "rays = 0 is not in [1, 100000]");
  }
  config = {};
  config.max_range_m = std::nan("");
  EXPECT_THROW(RangeFinder{config}, std::invalid_argument);
  config = {};
  config.dropout_probability = 1.5;
  EXPECT_THROW(RangeFinder{config}, std::invalid_argument);
}

}  // namespace
}  // namespace voronaut
