#include "voronaut/dynamics/models/unicycle.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

// Without limits that matter: what is asked for is there at once.
UnicycleConfig at_once() {
  return {.max_acceleration_m_s2 = 1000, .max_yaw_acceleration_rad_s2 = 1000};
}

double speed_m_s(const VehicleState& s) { return s.v_world.head<2>().dot(s.heading_world()); }

TEST(Unicycle, DrivesACircleOfRadiusSpeedOverYawRate) {
  const Unicycle model(at_once());
  VehicleState state = model.at_rest({0, 0, 0}, {1, 0});
  state.v_world = {1.5, 0, 0};
  state.w_body.z() = 1;
  // Centre (0, 1.5); a turn takes 2 pi s.
  for (int i = 0; i < 157; ++i) {
    state = model.step(state, {{1.5, 1, 0, 0}}, kPeriod_s);
    EXPECT_NEAR((state.p_world - Vec3(0, 1.5, 0)).norm(), 1.5, 1e-9);
  }
  EXPECT_NEAR(state.p_world.x(), 1.5 * std::sin(1.57), 1e-9);
  EXPECT_NEAR(state.p_world.y(), 1.5 - 1.5 * std::cos(1.57), 1e-9);
  EXPECT_NEAR(state.heading_world().y(), std::sin(1.57), 1e-9);
}

TEST(Unicycle, ReachesASpeedAtItsAccelerationAndKeepsIt) {
  const Unicycle model(UnicycleConfig{.max_acceleration_m_s2 = 3});
  // 2 m/s after 2/3 s, half way between two steps: the ramp ends within one.
  const VehicleState state = coast(model, model.at_rest({0, 0, 0}, {0, 1}), {{2, 0, 0, 0}}, 1);
  EXPECT_NEAR(speed_m_s(state), 2, 1e-12);
  EXPECT_NEAR(state.p_world.y(), 2 * (1 - 0.5 * 2.0 / 3), 1e-9);
  EXPECT_NEAR(state.p_world.x(), 0, 1e-12);
}

TEST(Unicycle, FollowsWithItsLag) {
  const Unicycle model(UnicycleConfig{.max_acceleration_m_s2 = 1000, .drive_lag_s = 0.2});
  const VehicleState state = coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{1, 0, 0, 0}}, 0.3);
  EXPECT_NEAR(speed_m_s(state), 1 - std::exp(-1.5), 1e-12);
  EXPECT_NEAR(state.p_world.x(), 0.3 - 0.2 * (1 - std::exp(-1.5)), 1e-9);
}

// At first as fast as it may, then with the lag: the two meet where the lag asks for the limit.
TEST(Unicycle, IsHeldBackByItsLimitBeforeItsLag) {
  const Unicycle model(UnicycleConfig{.max_acceleration_m_s2 = 2, .drive_lag_s = 0.5});
  const VehicleState state = coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{2, 0, 0, 0}}, 1.5);
  // 1 m/s after 0.5 s; what is missing then goes down by exp(-1 / 0.5).
  EXPECT_NEAR(speed_m_s(state), 2 - std::exp(-2), 1e-12);
}

TEST(Unicycle, ClipsWhatIsAskedForToItsLimits) {
  const Unicycle model(UnicycleConfig{});
  const VehicleState state = coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{9, -9, 0, 0}}, 3);
  EXPECT_NEAR(speed_m_s(state), 2.5, 1e-12);
  EXPECT_NEAR(state.w_body.z(), -2, 1e-12);
}

}  // namespace
}  // namespace voronaut::testing
