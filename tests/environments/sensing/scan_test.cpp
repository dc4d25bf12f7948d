#include "voronaut/environments/sensing/scan.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(BeamFan, SpreadsFromRightToLeftWithBothEndsIncluded) {
  const BeamFan fan = BeamFan::spread(kPi / 2, 3);
  ASSERT_EQ(fan.direction_sensor.size(), 3U);
  const double diagonal = std::sqrt(0.5);
  EXPECT_NEAR((fan.direction_sensor[0] - Vec2(diagonal, -diagonal)).norm(), 0, 1e-15);
  EXPECT_NEAR((fan.direction_sensor[1] - Vec2(1, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((fan.direction_sensor[2] - Vec2(diagonal, diagonal)).norm(), 0, 1e-15);
  EXPECT_FALSE(fan.full_circle());
}

TEST(BeamFan, FullCircleDoesNotRepeatItsFirstBeam) {
  const BeamFan fan = BeamFan::spread(2 * kPi, 4);
  EXPECT_NEAR((fan.direction_sensor[0] - Vec2(-1, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((fan.direction_sensor[3] - Vec2(0, 1)).norm(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(fan.bearing_step_rad, kPi / 2);
  EXPECT_TRUE(fan.full_circle());
}

TEST(BeamFan, SingleBeamLooksStraightAhead) {
  for (const double field_of_view_rad : {0.0, kPi / 2, 2 * kPi}) {
    const BeamFan fan = BeamFan::spread(field_of_view_rad, 1);
    ASSERT_EQ(fan.direction_sensor.size(), 1U);
    EXPECT_EQ(fan.direction_sensor[0], Vec2(1, 0));
    EXPECT_FALSE(fan.full_circle());
  }
}

TEST(BeamFan, DirectionsAreUnitVectors) {
  const BeamFan fan = BeamFan::spread(2 * kPi, 997);
  for (const Vec2& d : fan.direction_sensor) EXPECT_NEAR(d.norm(), 1, 1e-15);
}

TEST(Scan, TurnsBeamsByTheHeadingOfTheSensor) {
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(kPi / 2, 3));
  scan.sensor_world = {Vec2(1, 2), Vec2(0, 1)};
  scan.max_range_m = 5;
  scan.range_m = {5, 2, std::nan("")};
  EXPECT_NEAR((scan.point_world(1) - Vec2(1, 4)).norm(), 0, 1e-15);
  EXPECT_FALSE(scan.is_return(0));
  EXPECT_TRUE(scan.is_return(1));
  EXPECT_FALSE(scan.is_return(2));
}

}  // namespace
}  // namespace voronaut
