#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"

// What every regulator promises with a vehicle that it fits. Two suites: RegulatorConformance for
// all, StableRegulatorConformance for those that fly. Instantiate both with RegulatorPair values.
namespace voronaut::testing {

struct RegulatorPair {
  std::string vehicle;
  std::string regulator;
};

inline void PrintTo(const RegulatorPair& pair, std::ostream* out) {
  *out << pair.vehicle << " with " << pair.regulator;
}

class RegulatorConformance : public ::testing::TestWithParam<RegulatorPair> {
 protected:
  using Vector2d = Eigen::Vector2d;
  using Guide = std::function<Setpoint(double time_s)>;

  static constexpr double kPeriod_s = 0.01;

  VehicleSpec spec_ = vehicle(GetParam().vehicle);
  RegulatorConfig config_ = regulator(GetParam().regulator);
  std::unique_ptr<Model> model_ = make_model(spec_.model);
  std::unique_ptr<Regulator> regulator_ = make_regulator(config_, spec_, kPeriod_s);

  std::vector<VehicleState> fly(const VehicleState& start, double duration_s, const Guide& guide) {
    std::vector<VehicleState> states{start};
    regulator_->reset(start);
    Command pending = model_->hold();
    const int steps = static_cast<int>(duration_s / kPeriod_s + 0.5);
    for (int i = 0; i < steps; ++i) {
      const Command next = regulator_->regulate(guide(i * kPeriod_s), states.back());
      states.push_back(model_->step(states.back(), pending, kPeriod_s));
      pending = next;
    }
    return states;
  }

  static Vector2d along(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

  static Setpoint rest_at(const Vec3& p, const Vector2d& heading, double speed_m_s = 2.5) {
    return {p, speed_m_s, true, heading, 0};
  }

  static double tilt_rad(const VehicleState& s) {
    return std::acos(std::min(1.0, (s.q_world_body * Vec3::UnitZ()).z()));
  }
};

class StableRegulatorConformance : public RegulatorConformance {};

TEST_P(RegulatorConformance, LeavesAVehicleAtItsTargetAtRest) {
  if (const auto* literal = std::get_if<PaperLiteralConfig>(&config_)) {
    ASSERT_GT(literal->horizontal_kp, 0);  // its rest is unstable: round-off must not start it
  }
  const Vec3 p(3, -4, 1);
  const auto states = fly(model_->at_rest(p, {1, 0}), 3, [&](double) {
    return rest_at(p, {1, 0});
  });
  EXPECT_LT((states.back().p_world - p).norm(), 1e-9);
  EXPECT_LT(states.back().v_world.norm(), 1e-9);
}

TEST_P(RegulatorConformance, GivesTheSameBitsAfterReset) {
  const VehicleState start = model_->at_rest({0, 0, 0.5}, {0.6, 0.8});
  const auto guide = [](double) { return rest_at({1, 2, 1}, {1, 0}); };
  const auto first = fly(start, 0.8, guide);
  const auto second = fly(start, 0.8, guide);
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].p_world, second[i].p_world);
    ASSERT_EQ(first[i].q_world_body.coeffs(), second[i].q_world_body.coeffs());
  }
}

TEST_P(RegulatorConformance, AnswersMirroredSetUpsWithMirroredFlights) {
  const auto mirrored = [](const Vec3& p) { return Vec3(p.x(), -p.y(), p.z()); };
  const Vector2d heading = along(0.5);
  const auto here = fly(model_->at_rest({0, 0, 1}, heading), 0.5, [&](double) {
    return rest_at({2, 5, 1.2}, heading);
  });
  const Vector2d image(heading.x(), -heading.y());
  // The mirror image of a quadrotor has its rotors turning the other way: 1 mm/s apart.
  const double tolerance = std::holds_alternative<IdealConfig>(spec_.model) ? 1e-12 : 2e-3;
  const auto there = fly(model_->at_rest({0, 0, 1}, image), 0.5, [&](double) {
    return rest_at({2, -5, 1.2}, image);
  });
  for (std::size_t i = 0; i < here.size(); ++i) {
    ASSERT_LT((there[i].p_world - mirrored(here[i].p_world)).norm(), tolerance);
    ASSERT_LT((there[i].v_world - mirrored(here[i].v_world)).norm(), tolerance);
  }
}

TEST_P(RegulatorConformance, FirstMovesTowardsItsTargetInEveryDirection) {
  for (int yaw = 0; yaw < 8; ++yaw) {
    for (int bearing = 0; bearing < 8; ++bearing) {
      const Vector2d heading = along(0.785398 * yaw);
      const Vector2d direction = along(0.785398 * bearing + 0.3);
      const Vec3 target(50 * direction.x(), 50 * direction.y(), 1);
      const auto states = fly(model_->at_rest({0, 0, 1}, heading), 0.5,
                              [&](double) { return rest_at(target, heading, 1); });
      const Vector2d moved = states.back().p_world.head<2>();
      EXPECT_GT(moved.dot(direction), 0.9 * moved.norm());
      EXPECT_GT(moved.norm(), 1e-3);
    }
  }
}

TEST_P(StableRegulatorConformance, ConvergesFromOffsetsInEveryDirection) {
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
  // Full speed there, back and sideways, turning the gaze all the while.
  const auto guide = [](double t) {
    const Vec3 corner = t < 4 ? Vec3(1e6, 0, 1) : t < 8 ? Vec3(-1e6, 0, 2) : Vec3(0, 1e6, 1);
    return Setpoint{corner, 100, false, along(0.7 * t), 0.7};
  };
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 12, guide);
  double largest_tilt_rad = 0;
  double acceleration_m_s2 = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const VehicleState& s = states[i];
    EXPECT_LT(s.v_world.head<2>().norm(), 1.005 * spec_.limits.max_speed_m_s);
    EXPECT_LT(std::abs(s.w_body.z()), spec_.limits.max_yaw_rate_rad_s + 0.3);
    EXPECT_LT(std::abs(s.v_world.z()), 1.15);
    acceleration_m_s2 = std::max(acceleration_m_s2,
                                 (s.v_world - states[i - 1].v_world).head<2>().norm() / kPeriod_s);
  }
  // Turning round at full speed the tilt overshoots its command by 4.3 deg.
  EXPECT_LT(largest_tilt_rad, spec_.limits.max_tilt_rad + 0.08);
  EXPECT_LT(acceleration_m_s2, 1.25 * spec_.limits.max_acceleration_m_s2 + 1e-9);
}

TEST_P(StableRegulatorConformance, FliesAtTheSpeedLimitAndDoesNotBrakeForASubgoal) {
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 5, [](double) {
    return Setpoint{.p_target_world = {6, 0, 1}, .speed_limit_m_s = 1.2};
  });
  double speed_at_target_m_s = 0;
  for (const VehicleState& s : states) {
    if (s.p_world.x() < 5.9) speed_at_target_m_s = s.v_world.x();
  }
  EXPECT_NEAR(speed_at_target_m_s, 1.2, 0.01);
}

TEST_P(StableRegulatorConformance, FollowsATurningGazeWithoutLag) {
  const auto heading = [](double t) { return along(0.8 * t); };
  const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 10, [&](double t) {
    return Setpoint{{0, 0, 1}, 1, true, heading(t), 0.8};
  });
  EXPECT_LT((states.back().heading_world() - heading(10)).norm(), 0.03);
  EXPECT_LT((states.back().p_world - Vec3(0, 0, 1)).norm(), 0.01);
}

TEST_P(StableRegulatorConformance, TurnsRoundWhenAskedToLookBehind) {
  for (const double angle : {3.141592653589793, -3.0, 1.6}) {
    const auto states = fly(model_->at_rest({0, 0, 1}, {1, 0}), 8, [&](double) {
      return rest_at({0, 0, 1}, along(angle));
    });
    EXPECT_LT((states.back().heading_world() - along(angle)).norm(), 0.02) << angle;
  }
}

TEST_P(StableRegulatorConformance, StopsWithinItsStoppingLaw) {
  const StoppingLaw law = stopping_law(config_, spec_);
  for (const double v : {0.3, 1.0, 2.0, 2.5}) {
    VehicleState start = model_->at_rest({0, 0, 1}, {1, 0});
    start.v_world.x() = v;
    const auto states = fly(start, 10, [](double) {
      return Setpoint{.p_target_world = {100, 0, 1}, .speed_limit_m_s = 0};
    });
    const double stop_m = states.back().p_world.x();
    EXPECT_LT(stop_m, 1.02 * stopping_distance_m(v, law.k_1_s, law.a_m_s2) + v * kPeriod_s);
    EXPECT_GT(stop_m, 0.85 * stopping_distance_m(v, law.k_1_s, law.a_m_s2));
  }
}

}  // namespace voronaut::testing
