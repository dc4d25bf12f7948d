#pragma once

#include <algorithm>
#include <cmath>

#include "voronaut/tests/conformance/regulator_conformance.h"

// What every regulator that flies promises beyond RegulatorConformance.
namespace voronaut::testing {

class StableRegulatorConformance : public RegulatorConformance {};

// Beyond that, of those whose vehicle hovers: it has a height, looks where it is told and coasts
// under the command that holds it at rest.
class HoveringRegulatorConformance : public RegulatorConformance {};

TEST_P(HoveringRegulatorConformance, ConvergesFromOffsetsInEveryDirection) {
  for (int bearing = 0; bearing < 8; ++bearing) {
    const Vector2d from = along(0.785398 * bearing + 0.2);
    const Vec3 start(4 * from.x(), 4 * from.y(), 0.3 + 0.2 * bearing);
    const Vector2d heading = along(1.1 * bearing);
    const auto states = fly(model_->at_rest(start, heading), 14, [&](double) {
      return rest_at({0, 0, 1}, {1, 0});
    });
    EXPECT_LT((states.back().p_world - Vec3(0, 0, 1)).norm(), 0.01);
    EXPECT_LT(states.back().v_world.norm(), 0.01);
    EXPECT_LT((states.back().heading_world() - Vector2d(1, 0)).norm(), 0.02);
    double overshoot_m = 0;
    for (const VehicleState& s : states) {
      overshoot_m = std::max(overshoot_m, -s.p_world.head<2>().dot(from));
    }
    EXPECT_LT(overshoot_m, 0.02);
  }
}

TEST_P(StableRegulatorConformance, KeepsTheLimits) {
  // Full speed there, back and sideways, turning all the while.
  const auto guide = [](double t) {
    const Vec3 corner = t < 4 ? Vec3(1e6, 0, 1) : t < 8 ? Vec3(-1e6, 0, 2) : Vec3(0, 1e6, 1);
    return Setpoint{PassTarget{corner.head<2>(), 100}, corner.z(), along(0.7 * t), 0.7};
  };
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 12, guide);
  double largest_tilt_rad = 0;
  double acceleration_m_s2 = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const VehicleState& s = states[i];
    EXPECT_LT(s.v_world.head<2>().norm(), 1.005 * spec_.limits.max_speed_m_s);
    EXPECT_LT(std::abs(s.w_body.z()), spec_.limits.max_yaw_rate_rad_s + 0.3);
    EXPECT_LT(std::abs(s.v_world.z()), 1.15);
    largest_tilt_rad = std::max(largest_tilt_rad, tilt_rad(s));
    acceleration_m_s2 = std::max(acceleration_m_s2,
                                 (s.v_world - states[i - 1].v_world).head<2>().norm() / kPeriod_s);
  }
  // Turning round at full speed the tilt overshoots its command by 4.3 deg.
  EXPECT_LT(largest_tilt_rad, spec_.limits.max_tilt_rad + 0.08);
  EXPECT_LT(acceleration_m_s2, 1.25 * spec_.limits.max_acceleration_m_s2 + 1e-9);
}

TEST_P(StableRegulatorConformance, FliesAtTheSpeedLimitAndDoesNotBrakeForASubgoal) {
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 5, [](double) {
    return Setpoint{.motion = PassTarget{{6, 0}, 1.2}, .height_m = 1};
  });
  double speed_at_target_m_s = 0;
  for (const VehicleState& s : states) {
    if (s.p_world.x() < 5.9) speed_at_target_m_s = s.v_world.x();
  }
  EXPECT_NEAR(speed_at_target_m_s, 1.2, 0.01);
}

TEST_P(HoveringRegulatorConformance, FollowsATurningHeadingWithoutLag) {
  const auto heading = [](double t) { return along(0.8 * t); };
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 10, [&](double t) {
    return Setpoint{RestAtTarget{{0, 0}, 1}, 1, heading(t), 0.8};
  });
  EXPECT_LT((states.back().heading_world() - heading(10)).norm(), 0.03);
  EXPECT_LT((states.back().p_world - Vec3(0, 0, 1)).norm(), 0.01);
}

TEST_P(HoveringRegulatorConformance, TurnsRoundWhenAskedToLookBehind) {
  for (const double angle : {3.141592653589793, -3.0, 1.6}) {
    const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 8, [&](double) {
      return rest_at({0, 0, 1}, along(angle));
    });
    EXPECT_LT((states.back().heading_world() - along(angle)).norm(), 0.02) << angle;
  }
}

TEST_P(HoveringRegulatorConformance, StopsWithinItsStoppingLaw) {
  const StoppingLaw law = stopping_law(config_, spec_);
  for (const double v : {0.3, 1.0, 2.0, 2.5}) {
    VehicleState start = model_->at_rest({0, 0, 1}, {1, 0});
    start.v_world.x() = v;
    const auto states = fly(start, 10, [](double) {
      return Setpoint{.motion = PassTarget{{100, 0}, 0}, .height_m = 1};
    });
    const double stop_m = states.back().p_world.x();
    EXPECT_LT(stop_m, 1.02 * stopping_distance_m(v, law.k_1_s, law.a_m_s2) + v * kPeriod_s);
    EXPECT_GT(stop_m, 0.85 * stopping_distance_m(v, law.k_1_s, law.a_m_s2));
  }
}

}  // namespace voronaut::testing
