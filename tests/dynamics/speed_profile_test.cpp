#include "voronaut/dynamics/speed_profile.h"

#include <cmath>

#include <gmock/gmock.h>

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;
using Kind = SpeedProfileConfig::Kind;

double sigma(double x) { return 1 / (1 + std::exp(-x)); }

TEST(SpeedProfile, BrakesAtOneMetrePerSecondSquaredByDefault) {
  const SpeedProfile profile({});
  const double knee_m = 1 / (0.6 * 0.6);
  for (const double d : {3.0, 3.5, 4.0}) {
    EXPECT_DOUBLE_EQ(profile.speed_m_s(d, 2.5), std::sqrt(2 * (d - 0.5 * knee_m)));
  }
  EXPECT_DOUBLE_EQ(profile.speed_m_s(1, 2.5), 0.6);
  EXPECT_EQ(profile.speed_m_s(0, 2.5), 0);
  EXPECT_EQ(profile.speed_m_s(100, 2.5), 2.5);
  // V^2/(2 a_b) + a_b/(2 k_v^2): where braking from 2.5 m/s begins.
  EXPECT_LT(profile.speed_m_s(4.5, 2.5), 2.5);
  EXPECT_EQ(profile.speed_m_s(4.52, 2.5), 2.5);
  // One curve: the pieces meet with the same value.
  EXPECT_NEAR(profile.speed_m_s(knee_m - 1e-9, 9), profile.speed_m_s(knee_m + 1e-9, 9), 1e-8);
}

TEST(SpeedProfile, OfThePaperVanishesAtTheTarget) {
  const SpeedProfile profile({.kind = Kind::paper});
  EXPECT_EQ(profile.speed_m_s(0, 2.5), 0);
  EXPECT_NEAR(profile.speed_m_s(1.5, 2.5), 2.5 * (0.5 - sigma(-3)) / (1 - sigma(-3)), 1e-14);
  EXPECT_NEAR(profile.speed_m_s(50, 2.5), 2.5, 1e-12);
}

TEST(SpeedProfile, WithTheBarsMovedCreepsAtTheTarget) {
  const SpeedProfile profile({.kind = Kind::logistic});
  EXPECT_NEAR(profile.speed_m_s(0, 1) / sigma(-3), 1, 1e-14);
  EXPECT_DOUBLE_EQ(profile.speed_m_s(1.5, 2.5), 1.25);
  // Largest deceleration V dV/dd is (4/27) a V_max^2.
  double largest = 0;
  for (double d = 0; d < 5; d += 1e-4) {
    const double v = profile.speed_m_s(d, 2.5);
    largest = std::max(largest, v * (profile.speed_m_s(d + 1e-6, 2.5) - v) / 1e-6);
  }
  EXPECT_NEAR(largest, 4.0 / 27 * 2 * 2.5 * 2.5, 1e-4);
}

TEST(SpeedProfile, AsPrintedRunsAtHalfTheSpeedIntoTheTarget) {
  const SpeedProfile profile({.kind = Kind::literal});
  EXPECT_DOUBLE_EQ(profile.speed_m_s(0, 2.5), 1.25);
  const Vector2d near = profile.velocity_m_s({-1e-9, -1e-9}, 2.5);
  EXPECT_NEAR(near.x(), -1.25 * std::sqrt(0.5), 1e-8);
  // Each axis by its own distance: off the diagonal the velocity does not point at the target.
  const Vector2d off = profile.velocity_m_s({3, 1}, 2.5);
  EXPECT_NEAR(off.x(), 2.5 * sigma(6) * 3 / std::sqrt(10), 1e-14);
  EXPECT_NEAR(off.y(), 2.5 * sigma(2) / std::sqrt(10), 1e-14);
}

TEST(SpeedProfile, PointsAtTheTargetAndIsZeroThere) {
  for (const Kind kind : {Kind::sqrt, Kind::paper, Kind::logistic, Kind::literal}) {
    const SpeedProfile profile({.kind = kind});
    EXPECT_EQ(profile.velocity_m_s({0, 0}, 2.5), Vector2d(0, 0));
    const Vector2d v = profile.velocity_m_s({-300, 400}, 2.5);
    EXPECT_LT((v - Vector2d(-1.5, 2)).norm(), 1e-12);
    for (double d = 0; d < 10; d += 0.1) {
      EXPECT_LE(profile.speed_m_s(d, 2.5), profile.speed_m_s(d + 0.1, 2.5));
      EXPECT_LE(profile.speed_m_s(d, 2.5), 2.5);
    }
  }
}

}  // namespace
}  // namespace voronaut::testing
