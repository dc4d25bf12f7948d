#include "voronaut/dynamics/stopping.h"

#include <cmath>

#include <gmock/gmock.h>

namespace voronaut::testing {
namespace {

const double kTilt20_m_s2 = 9.81 * std::tan(20 * 3.141592653589793 / 180);

TEST(SafeSpeed, IsThatOfTheTable) {
  const double reaction_s[] = {0.01, 0.1, 0.2, 0.3};
  struct Row {
    double range_m, k_1_s, speed_m_s[4];
  };
  const Row table[] = {{2.5, 1.786, {3.05, 2.78, 2.51, 2.28}},
                       {2.5, 1.25, {2.47, 2.22, 2.00, 1.82}},
                       {5.0, 1.786, {5.06, 4.77, 4.47, 4.19}}};
  for (const Row& row : table) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(safe_speed_m_s(row.range_m, 0.5, reaction_s[i], row.k_1_s, kTilt20_m_s2),
                  row.speed_m_s[i], 0.0051);
    }
  }
}

TEST(SafeSpeed, StopsWhereItShould) {
  for (double range_m = 0.6; range_m < 8; range_m += 0.1) {
    for (const double reaction_s : {0.0, 0.06, 0.3}) {
      const double v = safe_speed_m_s(range_m, 0.5, reaction_s, 1.786, kTilt20_m_s2);
      EXPECT_NEAR(stopping_distance_m(v, 1.786, kTilt20_m_s2) + v * reaction_s, range_m - 0.5,
                  1e-12);
    }
  }
}

TEST(SafeSpeed, IsZeroWithoutRoom) {
  EXPECT_EQ(safe_speed_m_s(0.5, 0.5, 0.1, 1.786, 3.57), 0);
  EXPECT_EQ(safe_speed_m_s(0.1, 0.5, 0.1, 1.786, 3.57), 0);
}

TEST(StoppingDistance, HasNoJumpWhereTheTiltLimitBegins) {
  const double knee_m_s = 3.57 / 1.786;
  EXPECT_NEAR(stopping_distance_m(knee_m_s, 1.786, 3.57),
              stopping_distance_m(knee_m_s + 1e-9, 1.786, 3.57), 1e-8);
  EXPECT_DOUBLE_EQ(stopping_distance_m(1, 1.786, 3.57), 1 / 1.786);
}

}  // namespace
}  // namespace voronaut::testing
