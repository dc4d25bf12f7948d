#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "voronaut/dynamics/step_response.h"
#include "voronaut/tests/conformance/stable_regulator_conformance.h"

// What regulators bear: states that nobody meant, limits that hold them back, other periods.
namespace voronaut::testing {

// A number of any size: sign, and a power of ten up to 1e100.
inline double of_any_size(std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-6, 100);
  std::uniform_real_distribution<double> mantissa(-10, 10);
  return mantissa(random) * std::pow(10, std::floor(exponent(random)));
}

inline VehicleState any_state(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    return Vec3(of_any_size(random), of_any_size(random), of_any_size(random));
  };
  VehicleState state;
  state.p_world = vector();
  state.v_world = vector();
  state.w_body = vector();
  state.q_world_body =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
          .normalized();
  for (double& speed : state.actuators) speed = of_any_size(random);
  return state;
}

TEST_P(HolonomicRegulatorConformance, AsksForFiniteNumbersWhateverTheState) {
  std::mt19937 random(14);
  for (int i = 0; i < 2000; ++i) {
    regulator_->reset(any_state(random));
    for (int call = 0; call < 3; ++call) {
      const Eigen::Vector2d there(of_any_size(random), of_any_size(random));
      Setpoint setpoint{.height_m = of_any_size(random), .heading_world = along(0.1 * i)};
      if (call == 0) setpoint.motion = RestAtTarget{there, 2.5};
      if (call == 1) setpoint.motion = PassTarget{there, 2.5};
      if (call == 2) setpoint.motion = VelocityCommand{there};
      const Command command = regulator_->regulate(setpoint, any_state(random));
      for (const double u : command.u) ASSERT_TRUE(std::isfinite(u)) << i << " " << call;
    }
  }
}

TEST_P(HoveringRegulatorConformance, AsksOfNoRotorMoreThanItCan) {
  // Known exception. What pd_rate does against the yaw in its saturated demand may ask for a little
  // more; the model clips it.
  const double beyond_rad_s = std::holds_alternative<PdRateConfig>(config_) ? 6 : 1e-9;
  const auto* quadrotor = std::get_if<QuadrotorConfig>(&spec_.model);
  if (quadrotor == nullptr) GTEST_SKIP() << "has no rotors";
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-3, 3);
  VehicleState state = model_->at_rest({0, 0, 1}, {1, 0});
  regulator_->reset(state);
  for (int i = 0; i < 5000; ++i) {
    state.p_world += Vec3(any(random), any(random), any(random));
    state.v_world = Vec3(any(random), any(random), any(random));
    state.w_body = Vec3(any(random), any(random), any(random));
    state.q_world_body =
        Eigen::Quaterniond(3 + any(random), any(random), any(random), any(random)).normalized();
    const Command command = regulator_->regulate(rest_at({0, 0, 1}, along(any(random))), state);
    for (const double w : command.u) {
      ASSERT_GT(w, quadrotor->min_rotor_speed_rad_s - beyond_rad_s);
      ASSERT_LT(w, quadrotor->max_rotor_speed_rad_s + beyond_rad_s);
    }
  }
}

TEST_P(HoveringRegulatorConformance, RecoversFromAnyTiltAndComesBack) {
  if (std::holds_alternative<IdealConfig>(spec_.model)) GTEST_SKIP() << "never tilts";
  const auto guide = [](double) { return rest_at({0, 0, 1}, {1, 0}); };
  for (const int direction : {0, 2, 5, 7}) {
    for (const double tilted_rad : {0.5, 1.6, 2.4, 2.9}) {
      const Vector2d axis = along(0.785398 * direction + 0.1);
      VehicleState start = model_->at_rest({0, 0, 1}, {1, 0});
      start.q_world_body =
          Eigen::Quaterniond(Eigen::AngleAxisd(tilted_rad, Vec3(axis.x(), axis.y(), 0)));
      const auto states = fly(start, 90, guide);  // at 1 m/s it climbs back what it fell
      double largest_tilt_rad = 0;
      for (std::size_t i = 500; i < states.size(); ++i)
        largest_tilt_rad = std::max(largest_tilt_rad, tilt_rad(states[i]));
      EXPECT_LT(largest_tilt_rad, spec_.limits.max_tilt_rad + 0.08)
          << direction << " " << tilted_rad;
      EXPECT_LT((states.back().p_world - Vec3(0, 0, 1)).norm(), 0.01)
          << direction << " " << tilted_rad;
    }
  }
}

// Held where it is for 5 s while it is told to fly off, then let go. How far it overshoots then,
// beyond what it does when never held. A vehicle that is `tethered` may tilt meanwhile.
class HeldBackRegulatorConformance : public RegulatorConformance {
 protected:
  // Known exception. pd_rate takes acceleration from differences of velocity, as eq. (4) does: on a
  // tether, where there is none, it tilts on and on. Reading it from the attitude it does not.
  void SetUp() override {
    if (auto* pd_rate = std::get_if<PdRateConfig>(&config_)) {
      EXPECT_GT(overshoot_m(0.5, 5, true), 1);
      pd_rate->acceleration = PdRateConfig::Acceleration::attitude;
      regulator_ = make_regulator(config_, spec_, kPeriod_s);
    }
  }

  double overshoot_m(double distance_m, double held_s, bool tethered) {
    const Setpoint there = rest_at({distance_m, 0, 1}, {1, 0});
    VehicleState state = model_->at_rest({0, 0, 1}, {1, 0});
    regulator_->reset(state);
    Command pending = model_->hold();
    double farthest_m = 0;
    for (int i = 0; i < 3000; ++i) {
      const Command next = regulator_->regulate(there, state);
      const VehicleState stepped = model_->step(state, pending, kPeriod_s);
      pending = next;
      if (i * kPeriod_s >= held_s) {
        state = stepped;
      } else if (tethered) {
        const Vec3 p = state.p_world;
        state = stepped;
        state.p_world = p;
        state.v_world.setZero();
      }
      farthest_m = std::max(farthest_m, state.p_world.x() - distance_m);
    }
    return farthest_m;
  }
};

TEST_P(HeldBackRegulatorConformance, DoesNotWindUpWhileALimitHoldsItBack) {
  for (const bool tethered : {false, true}) {
    EXPECT_LT(overshoot_m(6, 5, tethered), overshoot_m(6, 0, tethered) + 0.01) << tethered;
  }
}

// Below its limits whoever learns takes the tether for wind, as far as it may.
TEST_P(HeldBackRegulatorConformance, OvershootsALittleWhenItsTetherIsCut) {
  for (const double distance_m : {0.2, 0.5, 1.0}) {
    const double more_m = overshoot_m(distance_m, 5, true) - overshoot_m(distance_m, 0, true);
    RecordProperty("more_m", std::to_string(more_m));
    EXPECT_LT(more_m, 0.25) << distance_m;
  }
}

TEST_P(HoveringRegulatorConformance, AnswersStepsAlikeAtOtherPeriods) {
  const VelocityStep usual = velocity_step(spec_, config_, 2.5, kPeriod_s);
  const PositionStep usual_place = position_step(spec_, config_, 5, kPeriod_s);
  for (const double period_s : {0.005, 0.02}) {
    const VelocityStep step = velocity_step(spec_, config_, 2.5, period_s);
    EXPECT_NEAR(step.rise_s, usual.rise_s, 0.03) << period_s;
    EXPECT_NEAR(step.settling_s, usual.settling_s, 0.05) << period_s;
    EXPECT_NEAR(step.overshoot_m_s, usual.overshoot_m_s, 0.01) << period_s;
    EXPECT_NEAR(step.max_tilt_rad, usual.max_tilt_rad, 0.02) << period_s;
    const PositionStep place = position_step(spec_, config_, 5, period_s);
    EXPECT_NEAR(place.settling_s, usual_place.settling_s, 0.05) << period_s;
    EXPECT_NEAR(place.overshoot_m, usual_place.overshoot_m, 0.003) << period_s;
    for (const double v : {0.3, 1.0, 2.5}) {
      EXPECT_NEAR(
          flown_stop_m(spec_, config_, v, period_s) / flown_stop_m(spec_, config_, v, kPeriod_s), 1,
          0.03)
          << period_s << " " << v;
    }
  }
}

TEST_P(HoveringRegulatorConformance, StepsWithoutMuchOvershootAndSettles) {
  const VelocityStep step = velocity_step(spec_, config_, 2.5, kPeriod_s);
  EXPECT_LT(step.overshoot_m_s, 0.02 * 2.5);
  EXPECT_LT(step.settling_s, 2.25);
  EXPECT_LT(step.height_error_m, 0.02);
  const PositionStep place = position_step(spec_, config_, 5, kPeriod_s);
  EXPECT_LT(place.overshoot_m, 0.021);
  EXPECT_LT(place.settling_s, 7);
}

}  // namespace voronaut::testing
