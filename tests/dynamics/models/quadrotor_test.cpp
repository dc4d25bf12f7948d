// Analytic cases of the rigid body (eqs. (1)-(2)) and its options.
#include "voronaut/dynamics/models/quadrotor.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "voronaut/tests/dynamics/closed_loop.h"
#include "voronaut/tests/dynamics/models/rigid_body.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;

Vec3 angular_momentum_world(const VehicleState& s, const QuadrotorConfig& c, double omega) {
  const Vec3 spin(0, 0, c.rotor_inertia_kg_m2 * omega);
  return s.q_world_body * (c.inertia_kg_m2().cwiseProduct(s.w_body) + spin);
}

TEST(Quadrotor, FallsFreelyWithStandingRotors) {  // V1
  const Quadrotor model(free_rotors());
  const VehicleState end = coast(model, level({0, 0, 1}, {1, -2, 3}), {}, 1);
  EXPECT_LT(worst(end.p_world, {1, -2, 1 + 3 - 4.905}), 1e-9);
  EXPECT_LT(worst(end.v_world, {1, -2, 3 - 9.81}), 1e-9);
}

TEST(Quadrotor, HoversWithoutDrift) {  // V2
  const Quadrotor model;
  const VehicleState start = model.at_rest({1, 2, 3}, {0.6, 0.8});
  const VehicleState end = coast(model, start, model.hold(), 10);
  EXPECT_LT(worst(end.p_world, start.p_world), 1e-12);
  EXPECT_LT(worst(end.v_world, Vec3::Zero()), 1e-12);
  EXPECT_NEAR(QuadrotorConfig{}.hover_rotor_speed_rad_s(), 213.488, 1e-3);
}

TEST(Quadrotor, ClimbsWithATenthMoreRotorSpeed) {  // V3
  const Quadrotor model;
  Command more = model.hold();
  for (double& w : more.u) w *= 1.1;
  const VehicleState end = coast(model, model.at_rest({0, 0, 1}, {1, 0}), more, 2);
  const double a = 0.21 * 9.81;
  EXPECT_NEAR(end.p_world.z(), 1 + 2 * a, 1e-9);  // 5.1202
  EXPECT_NEAR(end.v_world.z(), 2 * a, 1e-9);      // 4.1202
}

TEST(Quadrotor, SpinsAboutTheVertical) {  // V4
  const Quadrotor model(free_rotors());
  const VehicleState end = coast(model, level({0, 0, 0}, Vec3::Zero(), {0, 0, 2}), {}, 3);
  EXPECT_LT(attitude_difference(end.q_world_body, {std::cos(3.0), 0, 0, std::sin(3.0)}), 1e-9);
}

TEST(Quadrotor, RollsAQuarterTurn) {  // V5: p = 2 rad/s for pi/4 s
  const Quadrotor model(free_rotors());
  const double period_s = std::numbers::pi / 4 / 79;
  const VehicleState end =
      coast(model, level({0, 0, 0}, Vec3::Zero(), {2, 0, 0}), {}, std::numbers::pi / 4, period_s);
  const double half = std::numbers::sqrt2 / 2;
  EXPECT_LT(attitude_difference(end.q_world_body, {half, half, 0, 0}), 1e-9);
}

TEST(Quadrotor, PrecessesLikeATorqueFreeTop) {  // V6
  const Quadrotor model(free_rotors());
  const VehicleState end = coast(model, level({0, 0, 0}, Vec3::Zero(), {0.5, 0, 4}), {}, 3);
  EXPECT_LT(worst(end.w_body, {-0.462882786826, 0.189049003331, 4}), 1e-7);
}

TEST(Quadrotor, FlipsAboutItsIntermediateAxis) {  // V7
  QuadrotorConfig config = free_rotors(InertiaSet::custom);
  config.inertia_xx_kg_m2 = 0.006;
  config.inertia_yy_kg_m2 = 0.009;
  config.inertia_zz_kg_m2 = 0.0142;
  const Vec3 inertia = config.inertia_kg_m2();
  const Vec3 w0(0.01, 3, 0.01);
  const VehicleState start = level({0, 0, 0}, Vec3::Zero(), w0);
  const VehicleState end = coast(Quadrotor(config), start, {}, 10);
  EXPECT_LT(attitude_difference(end.q_world_body, {-0.00122390958128, 0.154547134234,
                                                   -0.000160944745658, 0.987984645347}),
            1e-8);
  EXPECT_LT(worst(end.w_body, {-0.0134016439111, -2.99998605225, 0.0109272643695}), 1e-9);
  const auto energy = [&](const Vec3& w) { return 0.5 * inertia.cwiseProduct(w).dot(w); };
  EXPECT_LT(std::abs(energy(end.w_body) / energy(w0) - 1), 2e-11);
  const Vec3 before = angular_momentum_world(start, config, 0);
  EXPECT_LT((angular_momentum_world(end, config, 0) - before).norm() / before.norm(), 3e-9);
}

TEST(Quadrotor, KeepsAngularMomentumOnlyWithThisSignOfOmega) {  // V8
  QuadrotorConfig config = free_rotors();
  config.drag_factor_N_m_s2 = 0;
  const Command command{{250, 170, 250, 170}};
  const VehicleState start = level({0, 0, 0}, Vec3::Zero(), {0.5, -0.3, 0.8});
  const VehicleState end = coast(Quadrotor(config), start, command, 5);
  const Vec3 exact(-0.548556167775, -0.197702126431, 0.8);
  EXPECT_LT(worst(end.w_body, exact), 1e-8);
  EXPECT_LT(worst(coast(Quadrotor(config), start, command, 5, 0.005).w_body, exact), 1e-9);
  const double omega = 250 - 170 + 250 - 170;
  EXPECT_LT(worst(angular_momentum_world(start, config, omega), {0.00405, -0.00243, 0.023184}),
            1e-12);
  EXPECT_LT(worst(angular_momentum_world(end, config, omega), {0.00405, -0.00243, 0.023184}), 1e-9);

  // A rotor of negative inertia is the other sign: it ends elsewhere and loses momentum.
  QuadrotorConfig other = config;
  other.rotor_inertia_kg_m2 = -config.rotor_inertia_kg_m2;
  const VehicleState wrong = coast(Quadrotor(other), start, command, 5);
  EXPECT_NEAR(wrong.w_body.x(), 0.0666, 1e-4);
  EXPECT_NEAR(wrong.w_body.y(), 0.5793, 1e-4);
  EXPECT_GT(
      (angular_momentum_world(wrong, config, omega) - angular_momentum_world(start, config, omega))
          .norm(),
      0.04);
}

double mechanical_energy(const VehicleState& s, const QuadrotorConfig& c) {
  return 0.5 * c.mass_kg * s.v_world.squaredNorm() + c.mass_kg * c.gravity_m_s2 * s.p_world.z() +
         0.5 * c.inertia_kg_m2().cwiseProduct(s.w_body).dot(s.w_body);
}

TEST(Quadrotor, GainsTheEnergyThatThrustAndTorquesPutIn) {  // V9
  const QuadrotorConfig config;
  const Quadrotor model(config);
  const VehicleState start = level({0, 0, 1});
  const auto power_W = [&](const VehicleState& s) {
    const auto& u = kR1.u;
    const double b = config.thrust_factor_N_s2;
    const double s1 = u[0] * u[0], s2 = u[1] * u[1], s3 = u[2] * u[2], s4 = u[3] * u[3];
    const Vec3 up = s.q_world_body * Vec3::UnitZ();
    const Vec3 torque(b * config.arm_m * (s4 - s2), b * config.arm_m * (s3 - s1),
                      config.drag_factor_N_m_s2 * (s2 + s4 - s1 - s3));
    return b * (s1 + s2 + s3 + s4) * up.dot(s.v_world) + torque.dot(s.w_body);
  };
  double work_J = 0;  // Simpson's rule over pairs of steps
  VehicleState state = start;
  for (int i = 0; i < 100; ++i) {
    const VehicleState middle = model.step(state, kR1, kPeriod_s);
    const VehicleState end = model.step(middle, kR1, kPeriod_s);
    work_J += kPeriod_s / 3 * (power_W(state) + 4 * power_W(middle) + power_W(end));
    state = end;
  }
  const double gained_J = mechanical_energy(state, config) - mechanical_energy(start, config);
  EXPECT_NEAR(gained_J, 29.67867914821, 3e-8);
  EXPECT_NEAR(work_J, gained_J, 1e-7);
}

TEST(Quadrotor, ClipsCommandsToTheRotorLimits) {
  const QuadrotorConfig config;
  const Quadrotor model(config);
  const VehicleState start = model.at_rest({0, 0, 1}, {1, 0});
  const VehicleState wild = model.step(start, {{-1e9, 1e9, -5, 1e3}}, kPeriod_s);
  const double low = config.min_rotor_speed_rad_s;
  const double high = config.max_rotor_speed_rad_s;
  EXPECT_THAT(wild.actuators, ::testing::ElementsAre(low, high, low, high));
  const VehicleState clipped = model.step(start, {{low, high, low, high}}, kPeriod_s);
  EXPECT_EQ(wild.v_world, clipped.v_world);
}

TEST(Quadrotor, RefusesRotorsThatCannotCarryIt) {
  QuadrotorConfig config;
  config.max_rotor_speed_rad_s = 200;
  EXPECT_THROW(Quadrotor{config}, std::invalid_argument);
}

TEST(Quadrotor, RotorsWithALagApproachTheirCommandExponentially) {
  QuadrotorConfig config;
  config.motor_lag_s = 0.03;
  const Quadrotor model(config);
  const VehicleState start = model.at_rest({0, 0, 1}, {1, 0});
  const double hover = start.actuators[0];
  const VehicleState end = coast(model, start, {{hover + 10, hover, hover, hover}}, 0.03);
  EXPECT_NEAR(end.actuators[0] - hover, 10 * (1 - std::exp(-1.0)), 2e-3);
  EXPECT_DOUBLE_EQ(end.actuators[1], hover);
}

TEST(Quadrotor, RotorsWithATinyLagFlyLikeRotorsWithout) {
  QuadrotorConfig config = free_rotors();
  const VehicleState without = coast(Quadrotor(config), level({0, 0, 1}), kR1, 1);
  config.motor_lag_s = 0.004;
  VehicleState start = level({0, 0, 1});
  start.actuators = kR1.u;
  const VehicleState with = coast(Quadrotor(config), start, kR1, 1);
  EXPECT_LT(worst(with.p_world, without.p_world), 1e-12);
}

TEST(Quadrotor, AcceleratingRotorsTurnTheBodyTheOtherWay) {
  QuadrotorConfig config = free_rotors();
  config.motor_lag_s = 0.05;
  config.rotor_acceleration_torque = true;
  config.drag_factor_N_m_s2 = 0;
  const Quadrotor model(config);
  const VehicleState start = model.at_rest({0, 0, 0}, {1, 0});
  const double hover = start.actuators[0];
  const Command command{{hover + 20, hover - 20, hover + 20, hover - 20}};
  const VehicleState end = coast(model, start, command, 0.5);
  // Angular momentum about z stays 0: I_zz r = -J_TP (change of Omega).
  const double omega = end.actuators[0] - end.actuators[1] + end.actuators[2] - end.actuators[3];
  EXPECT_GT(omega, 79);
  EXPECT_NEAR(end.w_body.z(), -config.rotor_inertia_kg_m2 * omega / 0.0142, 1e-12);
}

TEST(Quadrotor, LinearDragSlowsItExponentially) {
  QuadrotorConfig config;
  config.linear_drag_1_s = 0.25;
  const Quadrotor model(config);
  VehicleState start = model.at_rest({0, 0, 1}, {1, 0});
  start.v_world = {2, -1, 0};
  const VehicleState end = coast(model, start, model.hold(), 4);
  EXPECT_NEAR(end.v_world.x(), 2 * std::exp(-1.0), 1e-9);
  EXPECT_NEAR(end.v_world.y(), -std::exp(-1.0), 1e-9);
}

}  // namespace
}  // namespace voronaut::testing
