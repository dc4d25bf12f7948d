// The law of eqs. (3)-(4) as printed: it must fail, and at the times of an independent simulation.
#include "voronaut/dynamics/regulators/paper_literal.h"

#include <gmock/gmock.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;

struct FlipRow {
  InertiaSet inertia;
  double kp, kd, flip_s;
};

const FlipRow kFlips[] = {
    {InertiaSet::printed, 1, 1, 7.98},     {InertiaSet::printed, 10, 5, 3.19},
    {InertiaSet::printed, 20, 20, 2.92},   {InertiaSet::printed, 5, 50, 10.8},
    {InertiaSet::corrected, 1, 1, 3.82},   {InertiaSet::corrected, 10, 5, 1.18},
    {InertiaSet::corrected, 20, 20, 0.99}, {InertiaSet::corrected, 5, 50, 1.24},
};

double literal_flip_time_s(const FlipRow& row, bool typo_in_eq3) {
  QuadrotorConfig vehicle = quadrotor_with(row.inertia);
  vehicle.min_rotor_speed_rad_s = 0;
  vehicle.max_rotor_speed_rad_s = 2 * vehicle.hover_rotor_speed_rad_s();
  PaperLiteralConfig config;
  config.horizontal_kp = row.kp;
  config.horizontal_kd = row.kd;
  config.typo_in_eq3 = typo_in_eq3;
  const Quadrotor model(vehicle);
  PaperLiteral regulator(config, vehicle, tilt_limited(20), kPeriod_s);
  const Vec3 target = typo_in_eq3 ? Vec3(kFar_m, -kFar_m, 1) : Vec3(kFar_m, 0, 1);
  return flip_time_s(fly(model, regulator, model.at_rest({0, 0, 1}, {1, 0}), 15,
                         [&](double, const VehicleState&) { return pass(target, 2.5); }));
}

TEST(PaperLiteral, FlipsTheVehicleAsExpected) {
  for (const FlipRow& row : kFlips) {
    EXPECT_NEAR(literal_flip_time_s(row, false), row.flip_s, 0.06) << row.kp << ", " << row.kd;
  }
}

TEST(PaperLiteral, FlipsWithTheTypoOfEquationThreeAsWell) {
  for (const FlipRow& row : kFlips) EXPECT_GT(literal_flip_time_s(row, true), 0);
}

TEST(PaperLiteral, HoldsItsHeightUntilItFlips) {
  QuadrotorConfig vehicle;
  PaperLiteralConfig config;
  const Quadrotor model(vehicle);
  PaperLiteral regulator(config, vehicle, tilt_limited(20), kPeriod_s);
  const auto states =
      fly(model, regulator, model.at_rest({0, 0, 0}, {1, 0}), 5, [](double, const VehicleState&) {
        return pass({0, 0, 1}, 2.5);
      });
  EXPECT_NEAR(states.back().p_world.z(), 1, 0.01);
  EXPECT_EQ(flip_time_s(states), -1);
}

}  // namespace
}  // namespace voronaut::testing
