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

// What every regulator promises with a vehicle that it fits, stable or not. Instantiate with
// RegulatorPair values; those that fly also pass stable_regulator_conformance.h.
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
    return {RestAtTarget{p.head<2>(), speed_m_s}, p.z(), heading};
  }

  static double tilt_rad(const VehicleState& s) {
    return std::acos(std::min(1.0, (s.q_world_body * Vec3::UnitZ()).z()));
  }
};

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

// Of those that drive a vehicle which moves in every direction alike.
class HolonomicRegulatorConformance : public RegulatorConformance {};

TEST_P(HolonomicRegulatorConformance, FirstMovesTowardsItsTargetInEveryDirection) {
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

}  // namespace voronaut::testing
