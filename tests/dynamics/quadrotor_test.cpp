// Analytic cases and published reference trajectories of the rigid body (eqs. (1)-(2)).
#include "voronaut/dynamics/models/quadrotor.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "closed_loop.h"

namespace voronaut::testing {
namespace {

using InertiaSet = QuadrotorConfig::InertiaSet;

// No rotor limits, so that rotors may stand still.
QuadrotorConfig free_rotors(InertiaSet inertia = InertiaSet::corrected) {
  QuadrotorConfig config;
  config.inertia = inertia;
  config.min_rotor_speed_rad_s = 0;
  config.max_rotor_speed_rad_s = 1000;
  return config;
}

VehicleState level(const Vec3& p, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero()) {
  VehicleState state;
  state.p_world = p;
  state.v_world = v;
  state.w_body = w;
  return state;
}

double worst(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

double attitude_difference(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double sign = a.dot(b) < 0 ? -1 : 1;
  return (a.coeffs() - sign * b.coeffs()).cwiseAbs().maxCoeff();
}

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

const Command kR1{{212, 214.5, 213, 215}};

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

struct Reference {
  Vec3 p, v;
  Eigen::Quaterniond q;
  Vec3 w;
};

void expect_reached(const VehicleState& s, const Reference& r, double tolerance) {
  EXPECT_LT(worst(s.p_world, r.p), tolerance);
  EXPECT_LT(worst(s.v_world, r.v), tolerance);
  EXPECT_LT(attitude_difference(s.q_world_body, r.q), tolerance);
  EXPECT_LT(worst(s.w_body, r.w), tolerance);
}

VehicleState fly_r1(const Quadrotor& model, double duration_s, double period_s = kPeriod_s) {
  return coast(model, level({0, 0, 1}), kR1, duration_s, period_s);
}

VehicleState fly_r2(const Quadrotor& model, double period_s = kPeriod_s) {
  VehicleState state = level({0, 0, 1});
  state = coast(model, state, {{205, 213, 222, 213}}, 0.5, period_s);
  state = coast(model, state, {{222, 207, 205, 220}}, 0.5, period_s);
  return coast(model, state, {{210, 216, 214, 216}}, 1, period_s);
}

// R1, R2: an 8th-order integration with relative tolerance 1e-12, by an independent program.
TEST(Quadrotor, FollowsR1WithThePrintedInertia) {
  const Quadrotor model(free_rotors(InertiaSet::printed));
  expect_reached(fly_r1(model, 1),
                 {{0.0277520301348, -0.0139736574305, 1.00622476921},
                  {0.111053286451, -0.0557903138527, 0.0115059904814},
                  {0.999812956972, 0.0085507504944, 0.016943384459, 0.00372256097579},
                  {0.0341248579347, 0.0678183322535, 0.0148906690141}},
                 1e-10);
  expect_reached(fly_r1(model, 2),
                 {{0.444987152473, -0.220783270153, 1.0107549925},
                  {0.891012149269, -0.437573241172, -0.0193995194502},
                  {0.99700875781, 0.0338825273133, 0.06785195522, 0.0148870200587},
                  {0.0670036294479, 0.13625489982, 0.0297813380282}},
                 1e-10);
}

const Reference kR1Corrected2s{{4.22178055378, -1.7523983946, -0.384296505219},
                               {7.89052497364, -2.85241498923, -4.01256806516},
                               {0.715804818507, 0.278958563252, 0.62351524852, 0.145032122834},
                               {0.533511363222, 1.41999150312, 0.297813380282}};

const Reference kR2Corrected2s{{5.33317945859, -3.46123260796, -13.5131666454},
                               {2.39881512031, -0.90590685597, -16.3101550673},
                               {-0.161502256824, 0.266468336957, -0.927480040429, -0.20662144382},
                               {4.39688172004, 2.72022603368, 0.240179577465}};

TEST(Quadrotor, FollowsR1WithTheCorrectedInertia) {
  const Quadrotor model(free_rotors());
  expect_reached(fly_r1(model, 1),
                 {{0.277827018771, -0.135475317898, 0.982969729592},
                  {1.11040278119, -0.528857721708, -0.127624085385},
                  {0.981354196236, 0.0842093417938, 0.168744798138, 0.0371203634974},
                  {0.330917831242, 0.683268553004, 0.148906690141}},
                 1e-9);
  expect_reached(fly_r1(model, 2), kR1Corrected2s, 2e-9);
}

TEST(Quadrotor, FollowsR2WithBothInertias) {
  expect_reached(fly_r2(Quadrotor(free_rotors(InertiaSet::printed))),
                 {{3.27489567309, -1.45566827287, 0.400782899949},
                  {4.46136962172, -3.3638351214, -1.25531579524},
                  {0.940216065941, 0.272133627384, 0.203246132371, -0.0250608832445},
                  {0.442234924003, 0.270572412129, 0.0240179577465}},
                 2e-9);
  expect_reached(fly_r2(Quadrotor(free_rotors())), kR2Corrected2s, 1e-7);
}

TEST(Quadrotor, IntegratesToOrderFour) {
  const Quadrotor model(free_rotors());
  const VehicleState exact = fly_r2(model, 0.000625);
  const double coarse = worst(fly_r2(model, 0.01).p_world, exact.p_world);
  const double fine = worst(fly_r2(model, 0.005).p_world, exact.p_world);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.3);
}

TEST(Quadrotor, KeepsItsQuaternionOnTheSphere) {
  const VehicleState end = fly_r2(Quadrotor(free_rotors()));
  EXPECT_NEAR(end.q_world_body.norm(), 1, 1e-15);
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
  const VehicleState without = fly_r1(Quadrotor(config), 1);
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
