#include "voronaut/dynamics/regulators/rotor_allocation.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/models/rotor_wrench.h"

namespace voronaut::testing {
namespace {

TEST(RotorAllocation, GivesTheWrenchThatItIsAskedFor) {
  const QuadrotorConfig vehicle;
  const RotorAllocation allocation(vehicle);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Wrench asked{9.81 + 3 * any(random),
                       {0.3 * any(random), 0.3 * any(random), 0.02 * any(random)}};
    const Wrench given = wrench_of(vehicle, allocation.speeds(asked));
    EXPECT_NEAR(given.thrust_N, asked.thrust_N, 1e-12);
    EXPECT_LT((given.torque_N_m - asked.torque_N_m).norm(), 1e-13);
  }
}

TEST(RotorAllocation, GivesUpYawFirstThenTiltAndKeepsTheDirectionOfTheTilt) {
  const QuadrotorConfig vehicle;
  const RotorAllocation allocation(vehicle);
  const Wrench given =
      wrench_of(vehicle, allocation.speeds({.thrust_N = 12, .torque_N_m = {3, -4, 5}}));
  EXPECT_NEAR(given.thrust_N, 12, 1e-12);
  EXPECT_NEAR(given.torque_N_m.z(), 0, 1e-13);
  EXPECT_NEAR(given.torque_N_m.x() / given.torque_N_m.y(), -0.75, 1e-12);
  EXPECT_GT(given.torque_N_m.head<2>().norm(), 0.5);
}

TEST(RotorAllocation, LeavesRoomToTiltWithWhateverThrustIsAskedFor) {
  const QuadrotorConfig vehicle;
  const RotorAllocation allocation(vehicle);
  for (const double thrust_N : {-1e100, 0.0, 1e100}) {
    const Wrench given =
        wrench_of(vehicle, allocation.speeds({.thrust_N = thrust_N, .torque_N_m = {1, 0, 0}}));
    EXPECT_NEAR(given.torque_N_m.x(), 0.25 * allocation.max_tilt_torque_N_m(), 1e-12);
  }
}

TEST(RotorAllocation, KeepsEveryRotorWithinItsLimits) {
  QuadrotorConfig narrow;  // hovers close to the upper limit
  narrow.max_rotor_speed_rad_s = 1.02 * narrow.hover_rotor_speed_rad_s();
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-20, 20);
  for (const QuadrotorConfig& vehicle : {QuadrotorConfig{}, narrow}) {
    const RotorAllocation allocation(vehicle);
    for (int i = 0; i < 1000; ++i) {
      const Command command =
          allocation.speeds({any(random), {any(random), any(random), any(random)}});
      for (const double w : command.u) {
        ASSERT_GT(w, vehicle.min_rotor_speed_rad_s - 1e-9);
        ASSERT_LT(w, vehicle.max_rotor_speed_rad_s + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace voronaut::testing
