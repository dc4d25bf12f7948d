#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"

// What every vehicle model promises. Instantiate with the names of vehicles:
// INSTANTIATE_TEST_SUITE_P(Catalog, ModelConformance, ::testing::ValuesIn(vehicle_names()));
namespace voronaut::testing {

class ModelConformance : public ::testing::TestWithParam<std::string> {
 protected:
  static constexpr double kPeriod_s = 0.01;

  std::unique_ptr<Model> model_ = make_model(find_vehicle(GetParam()).model);

  // A state in motion, reached by pushing unevenly on what holds the vehicle.
  VehicleState moving() const {
    VehicleState state = model_->at_rest({3, -2, 1}, {0.6, 0.8});
    for (int i = 0; i < 50; ++i) state = model_->step(state, uneven(), kPeriod_s);
    return state;
  }

  Command uneven() const {
    Command command = model_->hold();
    command.u[0] += 0.5;
    command.u[1] -= 0.2;
    command.u[2] += 0.1;
    command.u[3] += 0.4;
    return command;
  }

  // The same state moved by `offset` and turned about the vertical through the origin.
  static VehicleState displaced(const VehicleState& s, const Vec3& offset,
                                const Eigen::Quaterniond& turn) {
    VehicleState moved = s;
    moved.p_world = turn * s.p_world + offset;
    moved.v_world = turn * s.v_world;
    moved.q_world_body = turn * s.q_world_body;
    return moved;
  }

  static double difference(const VehicleState& a, const VehicleState& b) {
    const double sign = a.q_world_body.dot(b.q_world_body) < 0 ? -1 : 1;
    return (a.p_world - b.p_world).norm() + (a.v_world - b.v_world).norm() +
           (a.w_body - b.w_body).norm() +
           (a.q_world_body.coeffs() - sign * b.q_world_body.coeffs()).norm();
  }

  static bool identical(const VehicleState& a, const VehicleState& b) {
    return a.p_world == b.p_world && a.v_world == b.v_world && a.w_body == b.w_body &&
           a.q_world_body.coeffs() == b.q_world_body.coeffs() && a.actuators == b.actuators;
  }
};

TEST_P(ModelConformance, StaysAtRestWhenHeld) {
  const VehicleState start = model_->at_rest({1, 2, 3}, {-0.8, 0.6});
  VehicleState state = start;
  for (int i = 0; i < 1000; ++i) state = model_->step(state, model_->hold(), kPeriod_s);
  EXPECT_LT(difference(state, start), 1e-12);
}

TEST_P(ModelConformance, RestsLevelLookingWhereItIsTold) {
  for (int i = 0; i < 16; ++i) {
    const double angle = -3.1 + 0.4 * i;
    const Eigen::Vector2d heading(std::cos(angle), std::sin(angle));
    const VehicleState state = model_->at_rest({0, 0, 0}, heading);
    EXPECT_LT((state.heading_world() - heading).norm(), 1e-14);
    EXPECT_LT((state.q_world_body * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-14);
    EXPECT_EQ(state.v_world.norm() + state.w_body.norm(), 0);
  }
}

TEST_P(ModelConformance, GivesTheSameBitsTwice) { EXPECT_TRUE(identical(moving(), moving())); }

TEST_P(ModelConformance, KeepsAUnitQuaternion) {
  EXPECT_NEAR(moving().q_world_body.norm(), 1, 1e-15);
}

TEST_P(ModelConformance, MovesAlikeWhereverItIsAndWhereverItLooks) {
  const Vec3 offset(100, -50, 7);
  const Eigen::Quaterniond turn(std::cos(0.6), 0, 0, std::sin(0.6));
  VehicleState here = moving();
  VehicleState there = displaced(here, offset, turn);
  Command command = uneven();
  Command turned = command;
  if (std::holds_alternative<IdealConfig>(find_vehicle(GetParam()).model)) {
    const Vec3 a = turn * Vec3(command.u[0], command.u[1], command.u[2]);
    turned.u = {a.x(), a.y(), a.z(), command.u[3]};  // this model's command is in world axes
  }
  for (int i = 0; i < 20; ++i) {
    here = model_->step(here, command, kPeriod_s);
    there = model_->step(there, turned, kPeriod_s);
  }
  EXPECT_LT(difference(there, displaced(here, offset, turn)), 1e-11);
}

TEST_P(ModelConformance, TwoHalfStepsAreOneStep) {
  const VehicleState start = moving();
  const VehicleState whole = model_->step(start, uneven(), kPeriod_s);
  const VehicleState half = model_->step(start, uneven(), kPeriod_s / 2);
  EXPECT_LT(difference(model_->step(half, uneven(), kPeriod_s / 2), whole), 1e-8);
}

TEST_P(ModelConformance, TakesWildCommandsForItsLimits) {
  const VehicleState start = model_->at_rest({0, 0, 1}, {1, 0});
  for (const double wild : {1e12, -1e12}) {
    const VehicleState next = model_->step(start, {{wild, wild, wild, wild}}, kPeriod_s);
    EXPECT_LT((next.v_world / kPeriod_s).norm(), 20.01);  // twice the weight at most
    EXPECT_LT(next.w_body.norm(), 50);
  }
}

}  // namespace voronaut::testing
