#include "voronaut/dynamics/models/car.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

VehicleState steered(const Car& model, double speed_m_s, double steering_rad) {
  VehicleState state = model.at_rest({0, 0, 0}, {1, 0});
  state.v_world.x() = speed_m_s;
  state.actuators[0] = steering_rad;
  return state;
}

TEST(Car, DrivesACircleOfWheelbaseOverTheTangentOfItsSteering) {
  const Car model;
  for (const double v_m_s : {1.5, -1.5}) {
    const VehicleState start = steered(model, v_m_s, 0.3);
    const double radius_m = 0.3302 / std::tan(0.3);
    VehicleState state = start;
    for (int i = 0; i < 200; ++i) {
      state = model.step(state, {}, kPeriod_s);
      EXPECT_NEAR((state.p_world - Vec3(0, radius_m, 0)).norm(), radius_m, 1e-7);
    }
    EXPECT_NEAR(state.w_body.z(), v_m_s / radius_m, 1e-12);
  }
}

TEST(Car, SteersNoFartherThanItsLimitAndNoFaster) {
  const Car model;
  const Command hard_left{{0, 100, 0, 0}};
  VehicleState state = model.at_rest({0, 0, 0}, {1, 0});
  state = model.step(state, hard_left, kPeriod_s);
  EXPECT_NEAR(state.actuators[0], 3.2 * kPeriod_s, 1e-15);
  state = coast(model, state, hard_left, 1);
  EXPECT_NEAR(state.actuators[0], 0.4189, 1e-12);
  EXPECT_EQ(state.p_world, Vec3(0, 0, 0)) << "steers on the spot";
}

TEST(Car, DrivesBackwards) {
  const Car model;
  const VehicleState state = coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{-1, 0, 0, 0}}, 1);
  EXPECT_NEAR(state.p_world.x(), -0.5, 1e-9);
  EXPECT_EQ(state.heading_world(), Eigen::Vector2d(1, 0));
}

}  // namespace
}  // namespace voronaut::testing
