// The cart against closed forms, conservation laws and reference drives.
#include "voronaut/dynamics/models/cart.h"

#include <cmath>

#include <gmock/gmock.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

CartConfig without_dry_friction() {
  CartConfig config;
  config.dry_friction_N_m = 0;
  return config;
}

double speed_m_s(const VehicleState& s) { return s.heading_world().dot(s.v_world.head<2>()); }

// [J]
double kinetic_energy(const CartCoefficients& c, const VehicleState& s) {
  const double v = speed_m_s(s);
  const double w = s.w_body.z();
  return 0.5 * (c.mass_kg * v * v + c.inertia_kg_m2 * w * w);
}

TEST(Cart, HasTheMassAndMotorsOfItsParts) {
  const CartCoefficients c{CartConfig{}};
  EXPECT_NEAR(c.mass_kg, 12.360, 5e-4);
  EXPECT_NEAR(c.inertia_kg_m2, 0.2016, 5e-5);
  EXPECT_NEAR(c.torque_N_m_V, 0.9926, 5e-5);
  EXPECT_NEAR(c.damping_N_m_s, 0.8890, 5e-5);
}

TEST(Cart, GathersSpeedAsAFirstOrderLag) {  // V10
  const Cart model(without_dry_friction());
  const VehicleState start = model.at_rest({0, 0, 0}, {0.6, 0.8});
  const double tau_s = 0.0660828647, v_end_m_s = 0.6531359201;
  for (const double t_s : {0.05, 0.1, 0.5}) {
    const VehicleState s = coast(model, start, {{6, 6, 0, 0}}, t_s);
    // A step is 4 % of the time constant: 6e-10 of error each.
    EXPECT_NEAR(speed_m_s(s), v_end_m_s * (1 - std::exp(-t_s / tau_s)), 5e-9) << t_s;
  }
  const VehicleState end = coast(model, start, {{6, 6, 0, 0}}, 0.5);
  EXPECT_LT((end.p_world - 0.2834292087 * Vec3(0.6, 0.8, 0)).norm(), 1e-9);
  EXPECT_EQ(end.w_body.z(), 0);
}

TEST(Cart, KeepsItsEnergyWithoutMotorsAndSwingsItsWeightToTheFront) {  // V11
  CartConfig config = without_dry_friction();
  config.torque_constant_N_m_A = 0;
  config.motor_friction_N_m_s = 0;
  const Cart model(config);
  VehicleState start = model.at_rest({0, 0, 0}, {1, 0});
  start.v_world.x() = 0.5;
  start.w_body.z() = 1;
  const VehicleState end = coast(model, start, {{12, -12, 0, 0}}, 10);
  EXPECT_NEAR(speed_m_s(end), 0.51605113, 1e-8);
  EXPECT_NEAR(end.w_body.z(), 0.00101132, 1e-8);
  const CartCoefficients c(config);
  EXPECT_NEAR(kinetic_energy(c, end) / kinetic_energy(c, start), 1, 1e-10);
}

struct Drive {
  double x_m, y_m, heading_rad, v_m_s, w_rad_s;
};

void expect_drive(const VehicleState& s, const Drive& r, double tolerance) {
  EXPECT_NEAR(s.p_world.x(), r.x_m, tolerance);
  EXPECT_NEAR(s.p_world.y(), r.y_m, tolerance);
  const Eigen::Vector2d heading(std::cos(r.heading_rad), std::sin(r.heading_rad));
  EXPECT_LT((s.heading_world() - heading).norm(), tolerance);
  EXPECT_NEAR(speed_m_s(s), r.v_m_s, tolerance);
  EXPECT_NEAR(s.w_body.z(), r.w_rad_s, tolerance);
}

// An 8th-order integration with relative tolerance 1e-12, by an independent program: u = (6, 5) V
// for 2 s from rest. What four steps per period leave of the error is 4e-7 with dry friction.
const Drive kRough{1.01292023671, 0.334156963344, 0.628708717624, 0.560471016548, 0.320346606539};
const Drive kSmooth{1.08248056315, 0.356498700533, 0.627577064515, 0.59885548302, 0.319714683148};

VehicleState reference_drive(const Cart& model, double period_s = kPeriod_s) {
  return coast(model, model.at_rest({0, 0, 0}, {1, 0}), {{6, 5, 0, 0}}, 2, period_s);
}

TEST(Cart, FollowsTheReferenceDrives) {
  expect_drive(reference_drive(Cart{}), kRough, 1e-6);
  expect_drive(reference_drive(Cart{without_dry_friction()}), kSmooth, 1e-9);
}

TEST(Cart, IntegratesToOrderFour) {
  const Cart model(without_dry_friction());
  const VehicleState exact = reference_drive(model, 0.005);
  const auto error_m = [&](double period_s) {
    return (reference_drive(model, period_s).p_world - exact.p_world).norm();
  };
  EXPECT_NEAR(std::log2(error_m(0.08) / error_m(0.04)), 4, 0.4);
}

TEST(Cart, GainsTheEnergyThatItsWheelsGiveIt) {
  const CartConfig config;
  const Cart model(config);
  const CartCoefficients c(config);
  const Command command{{9, -3, 0, 0}};
  const auto power_W = [&](const VehicleState& s) {
    double sum_W = 0;
    for (std::size_t i = 0; i < 2; ++i)
      sum_W += (c.torque_N_m_V * command.u[i] - c.resistance_N_m(s.actuators[i])) * s.actuators[i];
    return sum_W;
  };
  VehicleState s = model.at_rest({0, 0, 0}, {1, 0});
  double work_J = 0;
  const double period_s = 0.0005;
  for (int i = 0; i < 1000; ++i) {  // by Simpson's rule
    const VehicleState middle = model.step(s, command, period_s / 2);
    const VehicleState next = model.step(s, command, period_s);
    work_J += period_s / 6 * (power_W(s) + 4 * power_W(middle) + power_W(next));
    s = next;
  }
  EXPECT_NEAR(work_J, kinetic_energy(c, s), 1e-7);
  EXPECT_GT(work_J, 0.5);
}

TEST(Cart, ReachesTheSpeedOfItsMotorsAndNoMore) {
  const Cart model;
  const VehicleState start = model.at_rest({0, 0, 0}, {1, 0});
  EXPECT_NEAR(speed_m_s(coast(model, start, {{1e9, 1e9, 0, 0}}, 2)), 1.268, 1e-3);
  CartConfig balanced;
  balanced.center_of_mass_ahead_m = 0;  // else its weight pulls it outwards as it spins
  EXPECT_NEAR(coast(Cart(balanced), start, {{1e9, -1e9, 0, 0}}, 2).w_body.z(), 7.68, 0.01);
}

TEST(Cart, RollsWithoutSlipAndKeepsItsHeight) {
  const Cart model;
  VehicleState start = model.at_rest({1, 2, 0.3}, {0, 1});
  start.v_world = {0.4, 0.7, 0.2};  // sideways and upwards as well: wheels cannot
  const VehicleState s = model.step(start, {{5, 2, 0, 0}}, kPeriod_s);
  EXPECT_EQ(s.p_world.z(), 0.3);
  EXPECT_LT(std::abs(s.v_world.x() * s.heading_world().y() - s.v_world.y() * s.heading_world().x()),
            1e-15);
  EXPECT_LT(std::abs(s.p_world.x() - 1), 1e-4);
  const CartConfig c;
  EXPECT_NEAR(s.actuators[0] - s.actuators[1], 2 * c.half_track_m * s.w_body.z() / c.wheel_radius_m,
              1e-12);
  EXPECT_GT(s.w_body.z(), 0);  // the right wheel turns faster: to the left
}

}  // namespace
}  // namespace voronaut::testing
