#include "voronaut/dynamics/regulators/guidance.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "voronaut/dynamics/heading.h"

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

double error_of(double angle_rad) {
  const double from = 0.7;
  return heading_error_rad({std::cos(from), std::sin(from)},
                           {std::cos(from + angle_rad), std::sin(from + angle_rad)});
}

TEST(HeadingError, IsTheAngleForSmallAngles) {
  for (const double angle : {1e-12, 1e-6, 0.01, 0.1}) {
    EXPECT_NEAR(error_of(angle) / angle, 1, angle > 1e-9 ? 1e-6 : 1e-3);
    EXPECT_NEAR(error_of(-angle), -error_of(angle), 1e-15);
  }
}

TEST(HeadingError, IsAsCloseAsItsHeaderSays) {
  EXPECT_NEAR(error_of(0.5) / 0.5, 1, 3e-4);
  EXPECT_NEAR(error_of(pi / 2) / (pi / 2), 0.975, 0.001);
  EXPECT_LT(std::abs(error_of(pi)), 2.4);
  EXPECT_GT(std::abs(error_of(pi)), 2.3);
}

TEST(HeadingError, GrowsWithTheAngleAndKeepsItsSign) {
  double previous = 0;
  for (int i = 1; i <= 314; ++i) {
    const double error = error_of(0.01 * i);
    EXPECT_GT(error, previous) << i;
    EXPECT_LT(error_of(-0.01 * i), 0) << i;
    previous = error;
  }
}

TEST(HeadingError, TurnsLeftFromTheExactOpposite) {
  EXPECT_GT(heading_error_rad({1, 0}, {-1, 0}), 2.3);
}

TEST(DesiredVelocity, PointsAtTheTargetNoFasterThanEitherLimit) {
  const SpeedProfile profile({});
  VehicleState state;
  state.p_world = {1, 1, 5};
  Setpoint setpoint{.motion = PassTarget{{4, 5}, 2}};
  EXPECT_LT((desired_velocity(setpoint, state, profile, 2.5) - Vector2d(1.2, 1.6)).norm(), 1e-15);
  EXPECT_LT((desired_velocity(setpoint, state, profile, 1) - Vector2d(0.6, 0.8)).norm(), 1e-15);
  setpoint.motion = PassTarget{{1, 1}, 2};
  EXPECT_EQ(desired_velocity(setpoint, state, profile, 2.5), Vector2d(0, 0));
}

TEST(DesiredVelocity, BrakesForTheGoalOnly) {
  const SpeedProfile profile({});
  const VehicleState state;
  Setpoint setpoint{.motion = PassTarget{{1, 0}, 2.5}};
  EXPECT_DOUBLE_EQ(desired_velocity(setpoint, state, profile, 2.5).x(), 2.5);
  setpoint.motion = RestAtTarget{{1, 0}, 2.5};
  EXPECT_DOUBLE_EQ(desired_velocity(setpoint, state, profile, 2.5).x(), 0.6);
}

TEST(DesiredClimb, IsClippedToOneMetrePerSecond) {
  VehicleState state;
  Setpoint setpoint{.height_m = 0.3};
  EXPECT_DOUBLE_EQ(desired_climb_m_s(setpoint, state, 2), 0.6);
  setpoint.height_m = 30;
  EXPECT_DOUBLE_EQ(desired_climb_m_s(setpoint, state, 2), 1);
  setpoint.height_m = -30;
  EXPECT_DOUBLE_EQ(desired_climb_m_s(setpoint, state, 2), -1);
}

TEST(DesiredYawRate, AddsTheFeedforwardWithinTheLimit) {
  Setpoint setpoint;
  setpoint.yaw_rate_rad_s = 0.5;
  EXPECT_DOUBLE_EQ(desired_yaw_rate_rad_s(setpoint, {1, 0}, 2, 1), 0.5);
  setpoint.heading_world = {0, 1};
  EXPECT_DOUBLE_EQ(desired_yaw_rate_rad_s(setpoint, {1, 0}, 2, 1), 1);
  setpoint.heading_world = {0, -1};
  EXPECT_DOUBLE_EQ(desired_yaw_rate_rad_s(setpoint, {1, 0}, 2, 1), -1);
}

}  // namespace
}  // namespace voronaut::testing
