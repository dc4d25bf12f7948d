// Steps and stops of the regulators, held against an independent simulation, and what the integral
// part of one is for.
#include "voronaut/dynamics/step_response.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;

CascadePidConfig cascade(double velocity, double attitude, double rate) {
  CascadePidConfig config;
  config.gains = CascadePidConfig::Gains::custom;
  config.velocity_gain_1_s = velocity;
  config.attitude_gain_1_s = attitude;
  config.rate_gain_1_s = rate;
  return config;
}

Se3Config se3(double velocity, double pole_rad_s) {
  Se3Config config;
  config.gains = Se3Config::Gains::custom;
  config.velocity_gain_1_s = velocity;
  config.attitude_pole_rad_s = pole_rad_s;
  return config;
}

struct SteppedRow {
  InertiaSet inertia;
  RegulatorConfig regulator;
  double rise_s, overshoot, stop_m, max_tilt_deg;  // from rest to 2.5 m/s and back
};

const SteppedRow kSteps[] = {
    {InertiaSet::corrected, PdRateConfig{}, 1.15, 0, 1.48, 20.6},
    {InertiaSet::corrected, cascade(3, 8, 20), 0.83, 0.000, 1.23, 20.4},
    {InertiaSet::corrected, se3(3, 10), 0.86, 0.037, 1.33, 20.2},
    {InertiaSet::printed, cascade(2, 4.5, 12), 0.98, 0.018, 1.51, 19.7},
    {InertiaSet::printed, se3(2, 6), 1.02, 0.082, 1.62, 18.7},
};

TEST(StepResponse, IsThatOfAnIndependentSimulation) {
  for (const SteppedRow& row : kSteps) {
    VehicleSpec vehicle = find_vehicle("quadrotor");
    vehicle.model = quadrotor_with(row.inertia);
    const VelocityStep step = velocity_step(vehicle, row.regulator, 2.5, kPeriod_s);
    SCOPED_TRACE("row " + std::to_string(&row - kSteps));
    EXPECT_NEAR(step.rise_s, row.rise_s, 0.011);
    EXPECT_NEAR(step.overshoot_m_s / 2.5, row.overshoot, 0.003);
    EXPECT_NEAR(step.max_tilt_rad / kDegree, row.max_tilt_deg, 0.4);
    EXPECT_NEAR(flown_stop_m(vehicle, row.regulator, 2.5, kPeriod_s), row.stop_m, 0.015);
  }
}

TEST(StepResponse, AnswersForEveryVehicleThatShips) {
  for (const std::string& name : vehicle_names()) {
    const VehicleSpec vehicle = find_vehicle(name);
    const StepAnswer answer = step_answer(vehicle, find_regulator(vehicle.regulator), kPeriod_s);
    EXPECT_GT(answer.settling_s, kAnswerStep_m / vehicle.limits.max_speed_m_s) << name;
    EXPECT_LT(answer.settling_s, 12) << name;
    EXPECT_GE(answer.overshoot_m, 0) << name;
    EXPECT_LT(answer.overshoot_m, 0.1) << name;
    EXPECT_GT(answer.stopping_distance_m, 0) << name;
    EXPECT_LT(answer.stopping_distance_m, 2) << name;
  }
}

TEST(StepResponse, HasNoNumbersForWhatTipsOver) {
  const VehicleSpec vehicle = find_vehicle("quadrotor");
  const RegulatorConfig literal = find_regulator("paper_literal");
  EXPECT_TRUE(std::isnan(velocity_step(vehicle, literal, 2.5, kPeriod_s).rise_s));
  EXPECT_TRUE(std::isnan(position_step(vehicle, literal, 5, kPeriod_s).overshoot_m));
  EXPECT_TRUE(std::isnan(flown_stop_m(vehicle, literal, 2.5, kPeriod_s)));
}

// Speed reached when 2 m/s are asked for against drag, after so long.
double speed_against_drag_m_s(const RegulatorConfig& config, double drag_1_s, double after_s) {
  VehicleSpec spec = find_vehicle("quadrotor");
  std::get<QuadrotorConfig>(spec.model).linear_drag_1_s = drag_1_s;
  const auto model = make_model(spec.model);
  const auto regulator = make_regulator(config, spec, kPeriod_s);
  return fly(*model, *regulator, model->at_rest({0, 0, 1}, {1, 0}), after_s,
             [](double, const VehicleState&) {
               return pass({kFar_m, 0, 1}, 2);
             })
      .back()
      .v_world.x();
}

TEST(CascadePid, LearnsDragThatProportionalRegulatorsFallShortBy) {
  for (const double drag_1_s : {0.1, 0.3}) {
    CascadePidConfig proportional;
    proportional.integral_gain_1_s = 0;
    const double short_of = 2 * drag_1_s / (proportional.velocity_gain_1_s + drag_1_s);
    EXPECT_NEAR(2 - speed_against_drag_m_s(proportional, drag_1_s, 15), short_of, 0.01);
    EXPECT_NEAR(speed_against_drag_m_s(CascadePidConfig{}, drag_1_s, 15), 2, 0.005);
  }
}

TEST(CascadePid, LearnsNoMoreThanItsLimit) {
  CascadePidConfig config;
  config.integral_limit_m_s2 = 0.3;
  const double drag_m_s2 = 0.3 * speed_against_drag_m_s(config, 0.3, 15);
  EXPECT_NEAR(config.velocity_gain_1_s * (2 - drag_m_s2 / 0.3), drag_m_s2 - 0.3, 0.01);
}

TEST(CascadePid, LearnsNothingFromItsOwnSteps) {
  CascadePidConfig proportional;
  proportional.integral_gain_1_s = 0;
  const VehicleSpec vehicle = find_vehicle("quadrotor");
  EXPECT_NEAR(position_step(vehicle, CascadePidConfig{}, 5, kPeriod_s).settling_s,
              position_step(vehicle, proportional, 5, kPeriod_s).settling_s, 0.011);
  EXPECT_NEAR(flown_stop_m(vehicle, CascadePidConfig{}, 2.5, kPeriod_s),
              flown_stop_m(vehicle, proportional, 2.5, kPeriod_s), 0.005);
}

}  // namespace
}  // namespace voronaut::testing
