#include <gtest/gtest.h>

#include "voronaut/tests/planners/navigation/dash.h"

// Each condition of the governor's proof, broken: the vehicle touches.
namespace voronaut {
namespace {

using testing::Dash;
using testing::kBodyRadius_m;
using testing::post_at;
using testing::wall_at;

struct Broken {
  const char* vehicle;
  double wall_comes_s;     // too late to stop for
  double braking;          // share of what it promises
  double wall_at_start_m;  // too close for the speed it starts with
  double post_aside_m;     // of its course, and so missed by all beams until it is too late
};
// The jackal stops from 2 m/s within 0.3 m, for its acceleration is that of a controller, not of
// tyres. What is slow looks more often: the cart must come closer to the post before a beam meets
// it.
constexpr Broken kVehicles[] = {{"ideal", 1.0, 0.4, 0.9, 0.035},
                                {"unicycle", 1.0, 0.4, 0.9, 0.035},
                                {"jackal", 1.2, 0.1, 0.45, 0.035},
                                {"car", 1.0, 0.4, 0.9, 0.035},
                                {"cart", 2.4, 0.4, 0.9, 0.012}};

Dash dash_of(const Broken& vehicle) {
  Dash dash;
  dash.vehicle_name = vehicle.vehicle;
  dash.duration_s = 12;
  return dash;
}

TEST(GovernorConditions, AWorldThatMovesIsNotItsWorld) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    dash.shapes = {};
    dash.shapes_later = wall_at(2.6);
    dash.later_s = vehicle.wall_comes_s;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

TEST(GovernorConditions, RangesThatAreTooLongAreNotForgiven) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    dash.range_bias_m = 0.5;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

TEST(GovernorConditions, AVehicleThatBrakesWorseThanPromisedTouches) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    dash.braking = vehicle.braking;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

TEST(GovernorConditions, ACommandThatActsTooLateIsNotTheOneThatWasProved) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    dash.dead_time_s = 0.6;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

TEST(GovernorConditions, AStartAtFullSpeedBeforeAWallCannotBeMended) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    dash.shapes = dash.shapes_later = wall_at(vehicle.wall_at_start_m);
    dash.start_speed_m_s = 2.5;
    EXPECT_LT(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

TEST(GovernorConditions, APostThinnerThanTheBeamsSpacingSlipsThrough) {
  for (const Broken& vehicle : kVehicles) {
    Dash dash = dash_of(vehicle);
    // Between two beams of one degree: at 2.5 m they are 4.4 cm apart.
    dash.shapes = dash.shapes_later = post_at(Vec2(4, vehicle.post_aside_m), 0.0005);
    const double slips = dash.clearance_min_m();
    dash.shapes = dash.shapes_later = post_at(Vec2(4, 0), 0.03);
    EXPECT_LT(slips, kBodyRadius_m) << vehicle.vehicle;
    EXPECT_GE(dash.clearance_min_m(), kBodyRadius_m) << vehicle.vehicle;
  }
}

}  // namespace
}  // namespace voronaut
