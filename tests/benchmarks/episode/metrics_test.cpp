#include "voronaut/benchmarks/episode/metrics.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/dynamics/models/ideal.h"
#include "voronaut/dynamics/models/quadrotor.h"

namespace voronaut {
namespace {

Tick tick(double t_s, double x, double y, double vx, double clearance_m) {
  Tick tick;
  tick.t_s = t_s;
  tick.state.p_world = Vec3(x, y, 1);
  tick.state.v_world = Vec3(vx, 0, 0);
  tick.state.w_body = Vec3::Zero();
  tick.clearance_m = clearance_m;
  return tick;
}

// Along x for 3 m in 2 s, then 4 m along y in 2 s.
const std::vector<Tick> kCorner{tick(0, 0, 0, 0, 2.0), tick(1, 1, 0, 1, 1.0), tick(2, 3, 0, 2, 0.5),
                                tick(4, 3, 4, 0.5, 1.5)};

TEST(Metrics, PathLengthIsThatOfTheTrackInThePlane) {
  EXPECT_DOUBLE_EQ(path_length_m(kCorner), 7.0);
  std::vector<Tick> climbing = kCorner;
  climbing[2].state.p_world.z() = 50;
  EXPECT_DOUBLE_EQ(path_length_m(climbing), 7.0);
  EXPECT_DOUBLE_EQ(path_length_m({}), 0.0);
}

TEST(Metrics, ClearanceIsSmallestAndMeanOverTicks) {
  EXPECT_DOUBLE_EQ(clearance_smallest_m(kCorner), 0.5);
  EXPECT_DOUBLE_EQ(clearance_mean_m(kCorner), 1.25);
  EXPECT_TRUE(std::isnan(clearance_smallest_m({})));
  EXPECT_TRUE(std::isnan(clearance_mean_m({})));
}

TEST(Metrics, ClearanceMayBeNegativeInsideAnObstacle) {
  const std::vector<Tick> inside{tick(0, 0, 0, 0, -0.3), tick(1, 0, 0, 0, -0.1)};
  EXPECT_DOUBLE_EQ(clearance_smallest_m(inside), -0.3);
}

TEST(Metrics, MeanSpeedCountsFromDeparture) {
  EXPECT_DOUBLE_EQ(speed_mean_m_s(kCorner, 0), 7.0 / 4.0);
  EXPECT_DOUBLE_EQ(speed_mean_m_s(kCorner, 1), 6.0 / 3.0);
  EXPECT_DOUBLE_EQ(speed_mean_m_s(kCorner, 4), 0.0);
  EXPECT_DOUBLE_EQ(speed_max_m_s(kCorner), 2.0);
}

TEST(Metrics, TrackingErrorIsOverTheScansThatFollowAPath) {
  std::vector<ScanEvent> scans(4);
  scans[1].path_distance_m = 0.3;
  scans[3].path_distance_m = 0.1;
  EXPECT_DOUBLE_EQ(tracking_error(scans).rms_m, std::sqrt(0.05));
  EXPECT_DOUBLE_EQ(tracking_error(scans).max_m, 0.3);
  EXPECT_TRUE(std::isnan(tracking_error({scans.data(), 1}).rms_m));
  EXPECT_TRUE(std::isnan(tracking_error({}).max_m));
}

TEST(Metrics, EnergyIsTheRotorsPowerOverTime) {
  // At hover and then at twice that speed: 42.8 W, and eight times as much.
  const Quadrotor model;
  std::vector<Tick> ticks(3);
  for (std::size_t i = 0; i < 3; ++i) {
    ticks[i].t_s = 0.5 * static_cast<double>(i);
    ticks[i].state.actuators = model.hold().u;
  }
  EXPECT_NEAR(energy_j(ticks, model), 42.81, 0.01);
  for (double& w : ticks[2].state.actuators) w *= 2;
  EXPECT_NEAR(energy_j(ticks, model), 0.5 * 9 * 42.81, 0.05);
  EXPECT_TRUE(std::isnan(energy_j(ticks, Ideal(IdealConfig{}))));
}

TEST(Metrics, SplIsZeroForAFailureAndNeverAboveOne) {
  EXPECT_DOUBLE_EQ(spl(false, 10, 10, 0.2), 0.0);
  EXPECT_DOUBLE_EQ(spl(true, 10, 12.5, 0.2), 0.8);
  EXPECT_DOUBLE_EQ(spl(true, 10, 9.9, 0.2), 1.0);
}

TEST(Metrics, WhoStartsAtTheGoalAndGoesNowhereHasTakenTheShortestPath) {
  for (const double shortest_m : {0.0, 1e-300, 1e-6, 0.2}) {
    EXPECT_EQ(spl(true, shortest_m, 0, 0.2), 1.0);
    EXPECT_EQ(spl(true, shortest_m, 1e-17, 0.2), 1.0);
    EXPECT_EQ(spl(false, shortest_m, 0, 0.2), 0.0);
    EXPECT_EQ(path_ratio(shortest_m, shortest_m, 0.2), 1.0);
    EXPECT_DOUBLE_EQ(path_ratio(0.4, shortest_m, 0.2), 2.0) << "twice around the tolerance";
    EXPECT_DOUBLE_EQ(spl(true, shortest_m, 0.4, 0.2), 0.5);
  }
  EXPECT_DOUBLE_EQ(path_ratio(12, 10, 0.2), 1.2);
  EXPECT_TRUE(std::isnan(path_ratio(12, kAbsent, 0.2))) << "no path is no short path";
}

TEST(Metrics, MeanOfNothingIsAbsent) {
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_DOUBLE_EQ(mean(std::vector<double>{1, 2, 6}), 3.0);
}

TEST(Metrics, StateDigestSeesTheLastBitOfAnyState) {
  std::vector<Tick> other = kCorner;
  EXPECT_EQ(state_digest(kCorner), state_digest(other));
  other[1].state.w_body.z() = std::nextafter(other[1].state.w_body.z(), 1.0);
  EXPECT_NE(state_digest(kCorner), state_digest(other));
  EXPECT_EQ(state_digest(kCorner).size(), 16U);
}

}  // namespace
}  // namespace voronaut
