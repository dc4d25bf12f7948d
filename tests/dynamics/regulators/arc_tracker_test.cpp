#include "voronaut/dynamics/regulators/arc_tracker.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/dynamics/stopping.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;

constexpr MotionLimits kLimits{.max_acceleration_m_s2 = 3, .max_tilt_rad = 0};

struct Drive {
  UnicycleConfig vehicle;
  std::vector<VehicleState> operator()(const VehicleState& start, double duration_s,
                                       const Setpoint& setpoint) const {
    const Unicycle model(vehicle);
    ArcTracker regulator({}, vehicle, kLimits, kPeriod_s);
    return fly(model, regulator, start, duration_s,
               [&](double, const VehicleState&) { return setpoint; });
  }
  VehicleState at_rest() const { return Unicycle(vehicle).at_rest({0, 0, 0}, {1, 0}); }
};

TEST(ArcTracker, ComesToRestAtAPointInAnyDirection) {
  const Drive drive;
  for (int bearing = 0; bearing < 12; ++bearing) {
    const double angle = 0.5236 * bearing + 0.1;
    const Vector2d target = 3 * Vector2d(std::cos(angle), std::sin(angle));
    const auto states =
        drive(drive.at_rest(), 14, rest({target.x(), target.y(), 0}, kLimits.max_speed_m_s));
    EXPECT_LT((states.back().p_world.head<2>() - target).norm(), 0.03) << bearing;
    EXPECT_LT(states.back().v_world.norm(), 0.01) << bearing;
  }
}

TEST(ArcTracker, HoldsAnArcWithAndWithoutALag) {
  for (const double lag_s : {0.0, 0.1}) {
    Drive drive;
    drive.vehicle.drive_lag_s = lag_s;
    Setpoint arc;
    arc.motion = ArcCommand{1.2, -0.8};
    const VehicleState s = drive(drive.at_rest(), 3, arc).back();
    EXPECT_NEAR(s.v_world.head<2>().dot(s.heading_world()), 1.2, 1e-6) << lag_s;
    EXPECT_NEAR(s.w_body.z(), -0.8, 1e-6) << lag_s;
  }
}

TEST(ArcTracker, DrivesBackwardsWhenAnArcSaysSo) {
  const Drive drive;
  Setpoint arc;
  arc.motion = ArcCommand{-0.5, 0};
  const VehicleState s = drive(drive.at_rest(), 2, arc).back();
  EXPECT_LT(s.p_world.x(), -0.8);
  EXPECT_EQ(s.heading_world(), Vector2d(1, 0));
}

TEST(ArcTracker, TurnsOnTheSpotToTheHeadingWhenToldToStand) {
  const Drive drive;
  const Vector2d heading(-0.6, -0.8);
  const VehicleState s = drive(drive.at_rest(), 5, pass({9, 9, 0}, 0, heading)).back();
  EXPECT_LT((s.heading_world() - heading).norm(), 1e-3);
  EXPECT_LT(s.p_world.norm(), 1e-9);
}

TEST(ArcTracker, StopsWithinItsStoppingLawWithAndWithoutALag) {
  for (const double lag_s : {0.0, 0.1}) {
    Drive drive;
    drive.vehicle.drive_lag_s = lag_s;
    const StoppingLaw law = ArcTracker({}, drive.vehicle, kLimits, kPeriod_s).stopping_law();
    for (const double v : {0.3, 1.0, 2.0, 2.5}) {
      VehicleState start = drive.at_rest();
      start.v_world.x() = v;
      const double stop_m = drive(start, 5, pass({100, 0, 0}, 0)).back().p_world.x();
      EXPECT_LT(stop_m, 1.02 * stopping_distance_m(v, law.k_1_s, law.a_m_s2) + v * kPeriod_s);
      // That law has time to tilt in it, which wheels do not take.
      EXPECT_GT(stop_m, 0.7 * stopping_distance_m(v, law.k_1_s, law.a_m_s2));
    }
  }
}

// A turn of ninety degrees at full speed: across its course it never accelerates more than it may.
TEST(ArcTracker, SlowsDownForWhatItsCurvatureAllows) {
  const Drive drive;
  VehicleState start = drive.at_rest();
  start.v_world.x() = 2.5;
  for (const VehicleState& s : drive(start, 4, pass({1.5, 1.5, 0}, 2.5)))
    EXPECT_LT(s.v_world.norm() * std::abs(s.w_body.z()), 1.01 * 0.6 * 3);
}

}  // namespace
}  // namespace voronaut::testing
