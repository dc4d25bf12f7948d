#include "voronaut/dynamics/models/ideal.h"

#include <cmath>

#include <gmock/gmock.h>

#include "voronaut/dynamics/regulators/ideal.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

TEST(Ideal, AcceleratesUniformly) {
  const Ideal model;
  VehicleState start = model.at_rest({1, 2, 3}, {1, 0});
  start.v_world = {0.5, 0, 0};
  const VehicleState end = coast(model, start, {{1, -2, 0.5, 0}}, 2);
  EXPECT_LT((end.p_world - Vec3(1 + 1 + 2, 2 - 4, 3 + 1)).norm(), 1e-12);
  EXPECT_LT((end.v_world - Vec3(2.5, -4, 1)).norm(), 1e-12);
}

TEST(Ideal, ShortensTheAccelerationToItsLimitInItsDirection) {
  const Ideal model;
  const VehicleState end =
      model.step(model.at_rest({0, 0, 0}, {1, 0}), {{30, 40, 0, 0}}, kPeriod_s);
  EXPECT_LT((end.v_world / kPeriod_s - Vec3(1.8, 2.4, 0)).norm(), 1e-12);
}

TEST(Ideal, TurnsLevelAtNoMoreThanItsYawRate) {
  const Ideal model;
  const VehicleState end = coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{0, 0, 0, 50}}, 1.5);
  EXPECT_LT((end.heading_world() - Eigen::Vector2d(std::cos(3.0), std::sin(3.0))).norm(), 1e-12);
  EXPECT_EQ(end.w_body.z(), 2);
  EXPECT_EQ(cos_tilt(end), 1);
}

TEST(IdealRegulator, GivesHeightItsAccelerationFirst) {
  IdealRegulator regulator({}, {.max_acceleration_m_s2 = 3});
  const VehicleState at_rest = Ideal().at_rest({0, 0, 1}, {1, 0});
  const auto flat = regulator.regulate(pass({9, 0, 1}, 2.5), at_rest).u;
  EXPECT_DOUBLE_EQ(flat[0], 3);
  // A fifth of a metre too low asks for 0.2 * 1.667 * 5.4 m/s^2 upwards.
  const auto rising = regulator.regulate(pass({0, 9, 1.2}, 2.5), at_rest).u;
  EXPECT_NEAR(rising[2], 1.80036, 1e-9);
  EXPECT_NEAR(rising[1], std::sqrt(9 - 1.80036 * 1.80036), 1e-9);
}

}  // namespace
}  // namespace voronaut::testing
