// The cart under its regulator, each command applied one step later, held against the reference
// error dynamics and the numbers of an independent simulation.
#include "voronaut/dynamics/regulators/position_trajectory.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

using Eigen::Vector2d;

constexpr double kAhead_m = 0.15;  // h
constexpr double kNever_s = 1e9;

Vector2d along(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

Vector2d control_point(const VehicleState& s) {
  return s.p_world.head<2>() + kAhead_m * s.heading_world();
}

double speed_m_s(const VehicleState& s) { return s.heading_world().dot(s.v_world.head<2>()); }

PathSegment line(const Vector2d& from, const Vector2d& to) { return {.start = from, .end = to}; }

PathSegment circle(double radius_m, bool left) {
  return {.kind = PathSegment::Kind::arc,
          .start = {radius_m, 0},
          .end = {radius_m, 0},
          .counter_clockwise = left};
}

Setpoint follow(const PathSegment& segment, double speed_m_s,
                const Vector2d& target = Vector2d::Zero()) {
  return {.motion = PassTarget{target, speed_m_s, segment}};
}

Setpoint rest_at(const Vector2d& p, double speed_m_s) {
  return {.motion = RestAtTarget{p, speed_m_s}};
}

std::vector<VehicleState> drive(const VehicleState& start, double duration_s, const Guide& guide,
                                double max_speed_m_s = 1.25) {
  VehicleSpec spec = vehicle("cart");
  spec.limits.max_speed_m_s = max_speed_m_s;
  const Cart model;
  PositionTrajectory regulator({}, CartConfig{}, spec.limits, kPeriod_s);
  return fly(model, regulator, start, duration_s, guide);
}

std::vector<VehicleState> drive(const VehicleState& start, double duration_s,
                                const Setpoint& setpoint) {
  return drive(start, duration_s, [&](double, const VehicleState&) { return setpoint; });
}

VehicleState at_rest(const Vector2d& p, const Vector2d& heading) {
  return Cart().at_rest({p.x(), p.y(), 0}, heading);
}

// From when on `error` stays below `bound`.
template <class Error>
double settled_s(const std::vector<VehicleState>& states, double bound, const Error& error) {
  double since_s = 0;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (std::abs(error(states[i])) > bound) since_s = static_cast<double>(i + 1) * kPeriod_s;
  return since_s < static_cast<double>(states.size()) * kPeriod_s ? since_s : kNever_s;
}

// Times to settle here and below are an independent simulation's; where its control point starts is
// not known: within 0.1 s.
TEST(PositionTrajectory, ComesOntoALineWithoutOvershoot) {
  for (const double side : {1.0, -1.0}) {
    const auto states = drive(at_rest({0, side}, {1, 0}), 12, follow(line({0, 0}, {50, 0}), 1));
    const auto off_m = [&](const VehicleState& s) { return side * control_point(s).y(); };
    EXPECT_NEAR(settled_s(states, 0.02, off_m), 4.26, 0.1);
    for (const VehicleState& s : states) EXPECT_GT(off_m(s), -1e-6);
    EXPECT_NEAR(speed_m_s(states.back()), 1, 1e-3);
    EXPECT_LT(std::abs(states.back().p_world.y()), 1e-4);
  }
}

TEST(PositionTrajectory, HoldsACircleWithTheAxleInside) {
  struct Row {
    double radius_m, settle_s, axle_mm;
  };
  for (const Row& row : {Row{2, 4.86, -5.6}, Row{1, 5.39, -11.3}}) {
    for (const bool left : {true, false}) {
      const auto states = drive(at_rest({row.radius_m + 1, 0}, {0, left ? 1.0 : -1.0}), 25,
                                follow(circle(row.radius_m, left), 0.8));
      const auto off_m = [&](const VehicleState& s) {
        return control_point(s).norm() - row.radius_m;
      };
      EXPECT_NEAR(settled_s(states, 0.02, off_m), row.settle_s, 0.1);
      const VehicleState& end = states.back();
      EXPECT_LT(std::abs(off_m(end)), 1e-11);
      EXPECT_NEAR(end.p_world.head<2>().norm() - row.radius_m, 1e-3 * row.axle_mm, 5e-5);
      EXPECT_EQ(end.w_body.z() > 0, left);
    }
  }
}

// psi'' + T2 psi' + T1 psi = 0 with its double pole at -1.5, Hurwitz, and tan(delta/2) of the
// heading's angle to the course shrinking as exp(-V t/h): what the derivation says of small errors.
TEST(PositionTrajectory, ObeysItsReferenceErrorDynamics) {
  const double v = 0.8, psi_m = 0.1, delta = 0.3;
  VehicleState start =
      at_rest({-kAhead_m * std::cos(delta), psi_m - kAhead_m * std::sin(delta)}, along(delta));
  start.v_world.head<2>() = v * std::cos(delta) * along(delta);  // P moves along x
  start.w_body.z() = -v * std::sin(delta) / kAhead_m;
  const CartConfig config;
  const Cart model(config);
  PositionTrajectory regulator({}, config, vehicle("cart").limits, kPeriod_s);
  regulator.reset(start);
  const Setpoint setpoint = follow(line({0, 0}, {50, 0}), v);
  VehicleState s = start;
  Command pending = regulator.regulate(setpoint, s);  // as if it had been under way before
  double worst_psi_m = 0, worst_delta = 0;
  for (int i = 0; i < 500; ++i) {
    const double t = i * kPeriod_s;
    worst_psi_m = std::max(
        worst_psi_m, std::abs(control_point(s).y() - psi_m * (1 + 1.5 * t) * std::exp(-1.5 * t)));
    const double want = 2 * std::atan(std::tan(delta / 2) * std::exp(-v * t / kAhead_m));
    const double course = std::atan2(
        s.w_body.z() * kAhead_m * s.heading_world().x() + speed_m_s(s) * s.heading_world().y(), v);
    const double is = std::atan2(s.heading_world().y(), s.heading_world().x()) - course;
    worst_delta = std::max(worst_delta, std::abs(is - want));
    const Command next = regulator.regulate(setpoint, s);
    s = model.step(s, pending, kPeriod_s);
    pending = next;
  }
  EXPECT_LT(worst_psi_m, 0.003);  // of 0.1 m: commands act 15 ms late on average
  EXPECT_LT(worst_delta, 0.05);
  EXPECT_LT(std::abs(control_point(s).y()), 1e-3);
}

// While it comes onto a circle, its speed around it stays what it was told: the two are decoupled.
TEST(PositionTrajectory, HoldsItsSpeedAroundAnArcWhileItIsStillOffIt) {
  const double v = 0.5, radius_m = 1;
  VehicleState start = at_rest({1.15, -kAhead_m}, {0, 1});  // P at (1.15, 0)
  start.v_world.y() = v;
  const CartConfig config;
  const Cart model(config);
  PositionTrajectory regulator({}, config, vehicle("cart").limits, kPeriod_s);
  regulator.reset(start);
  const Setpoint setpoint = follow(circle(radius_m, true), v);
  VehicleState s = start;
  Command pending = regulator.regulate(setpoint, s);
  double worst_m_s = 0, inwards_m_s = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector2d out = control_point(s).normalized();
    const Vector2d left(-s.heading_world().y(), s.heading_world().x());
    const Vector2d velocity = s.v_world.head<2>() + kAhead_m * s.w_body.z() * left;
    worst_m_s = std::max(worst_m_s, std::abs(velocity.dot(Vector2d(-out.y(), out.x())) - v));
    inwards_m_s = std::max(inwards_m_s, -velocity.dot(out));
    const Command next = regulator.regulate(setpoint, s);
    s = model.step(s, pending, kPeriod_s);
    pending = next;
  }
  EXPECT_GT(inwards_m_s, 0.05);
  EXPECT_LT(worst_m_s, 0.008);
  EXPECT_NEAR(control_point(s).norm(), radius_m, 0.01);
}

TEST(PositionTrajectory, ComesToRestOnAPointWithItsAxle) {
  const auto states = drive(at_rest({0, 0}, {1, 0}), 15, rest_at({3, 2}, 1));
  const auto off_m = [](const VehicleState& s) {
    return (s.p_world.head<2>() - Vector2d(3, 2)).norm();
  };
  // The independent simulation stops its control point there, not its axle, and takes 5.85 s.
  EXPECT_NEAR(settled_s(states, 0.02, off_m), 6.20, 0.05);
  EXPECT_LT(off_m(states.back()), 1e-5);
  for (const VehicleState& s : states)
    EXPECT_LT((s.p_world.head<2>() - Vector2d(3, 2)).dot(Vector2d(3, 2).normalized()), 1e-4);
}

TEST(PositionTrajectory, ConvergesFromOffsetsInEveryDirectionWithEveryHeading) {
  for (int bearing = 0; bearing < 8; ++bearing) {
    for (int heading = 0; heading < 8; ++heading) {
      const Vector2d from = along(0.785398 * bearing + 0.2);
      const auto states =
          drive(at_rest(4 * from, along(0.785398 * heading)), 14, rest_at({0, 0}, 2.5));
      EXPECT_LT(states.back().p_world.norm(), 0.01);
      EXPECT_LT(std::abs(speed_m_s(states.back())), 0.01);
    }
  }
}

TEST(PositionTrajectory, TurnsOnTheSpotFirstWhenTheGoalIsBehind) {
  for (const Vector2d& goal : {Vector2d(-3, 0.5), Vector2d(-3, 0), Vector2d(-2, -2)}) {
    for (const Setpoint& setpoint : {rest_at(goal, 1), follow(line({0, 0}, goal), 1, goal)}) {
      const auto states = drive(at_rest({0, 0}, {1, 0}), 3, setpoint);
      const auto off_heading = [&](const VehicleState& s) {
        return std::acos(std::min(1.0, s.heading_world().dot(goal.normalized()))) / kDegree;
      };
      for (const VehicleState& s : states) {
        if (off_heading(s) > 25) {
          EXPECT_LT(s.p_world.head<2>().norm(), 0.02);
        }
        EXPECT_GT(speed_m_s(s), -0.02) << "it does not reverse";
      }
      EXPECT_LT(off_heading(states.back()), 10);
      EXPECT_GT(states.back().p_world.head<2>().dot(goal.normalized()), 0.2);
    }
  }
}

TEST(PositionTrajectory, StandsAndTurnsWhereItIsTold) {
  Setpoint setpoint = rest_at({5, 5}, 0);
  setpoint.heading_world = along(2.5);
  const auto states = drive(at_rest({1, 2}, {1, 0}), 8, setpoint);
  EXPECT_LT((states.back().heading_world() - along(2.5)).norm(), 0.02);
  // Its centre of mass is not on the axle: turning pulls it 4 mm.
  EXPECT_LT((states.back().p_world - Vec3(1, 2, 0)).norm(), 0.005);
}

// (0, 0) to (20, 20): the mean speed until 0.5 m from the goal. 1.25 m/s makes the cart paper's
// 1.19 m/s, 1.3 m/s is more than the motors have.
TEST(PositionTrajectory, DrivesThePapersMissionAtThePapersMeanSpeed) {
  struct Row {
    double cruise_m_s, mean_m_s;
  };
  for (const Row& row : {Row{1.2, 1.15}, Row{1.25, 1.19}, Row{1.3, 1.21}}) {
    const Vector2d goal(20, 20);
    const auto states = drive(
        at_rest({0, 0}, goal.normalized()), 40,
        [&](double, const VehicleState&) { return rest_at(goal, row.cruise_m_s); }, row.cruise_m_s);
    const auto near = std::ranges::find_if(
        states, [&](const VehicleState& s) { return (s.p_world.head<2>() - goal).norm() < 0.5; });
    const double t_s = static_cast<double>(near - states.begin()) * kPeriod_s;
    EXPECT_NEAR(near->p_world.norm() / t_s, row.mean_m_s, 0.011) << row.cruise_m_s;
    EXPECT_LT((states.back().p_world.head<2>() - goal).norm(), 0.01);
  }
}

TEST(PositionTrajectory, StopsWithinItsStoppingLaw) {
  const VehicleSpec spec = vehicle("cart");
  const StoppingLaw law = stopping_law(regulator("position_trajectory"), spec);
  for (const double v : {0.5, 0.8, 1.0, 1.2}) {
    const double told_s = 6;
    const auto states = drive(at_rest({0, 0}, {1, 0}), 12, [&](double t, const VehicleState&) {
      return follow(line({0, 0}, {50, 0}), t < told_s ? v : 0);
    });
    const double stop_m = states.back().p_world.x() -
                          states[static_cast<std::size_t>(told_s / kPeriod_s)].p_world.x();
    const double exact_m = v * v / 2 + 1 / (2 * law.k_1_s * law.k_1_s) + v * kPeriod_s;
    EXPECT_NEAR(stop_m, exact_m, 0.005) << v;  // 1 m/s^2 down to 1/k, then exponentially
    EXPECT_LT(stop_m, 1.02 * stopping_distance_m(v, law.k_1_s, law.a_m_s2)) << v;
    EXPECT_GT(stop_m, 0.85 * stopping_distance_m(v, law.k_1_s, law.a_m_s2)) << v;
    EXPECT_LT(stop_m, v * v / 2 + 0.14 * v) << v;
  }
}

TEST(PositionTrajectory, ScalesBothVoltagesTogether) {
  CartConfig weak;
  weak.max_voltage_V = 4;
  const MotionLimits limits = vehicle("cart").limits;
  VehicleState s = at_rest({0, 0}, {1, 0});
  s.v_world.x() = 0.7;
  const Setpoint setpoint = follow(line({0, 1}, {50, 1}), 1);
  const Command strong =
      PositionTrajectory({}, CartConfig{}, limits, kPeriod_s).regulate(setpoint, s);
  const Command scaled = PositionTrajectory({}, weak, limits, kPeriod_s).regulate(setpoint, s);
  ASSERT_GT(strong.u[0], 4);
  EXPECT_EQ(scaled.u[0], 4);
  EXPECT_NEAR(scaled.u[1], 4 * strong.u[1] / strong.u[0], 1e-14);
}

TEST(PositionTrajectory, HeadsForTheTargetWhereAnArcHasNoDirection) {
  const Setpoint setpoint = follow(circle(2, true), 1, {2, 0});
  const auto states = drive(at_rest({-kAhead_m, 0}, {1, 0}), 0.5, setpoint);  // P at its centre
  EXPECT_GT(states.back().p_world.x(), -kAhead_m + 0.02);
}

}  // namespace
}  // namespace voronaut::testing
