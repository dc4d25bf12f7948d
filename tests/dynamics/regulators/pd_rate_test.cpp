// Signs, frames, shares of the rotor speed and recovery of pd_rate.
#include "voronaut/dynamics/regulators/pd_rate.h"

#include <utility>

#include <gmock/gmock.h>

#include "voronaut/tests/dynamics/closed_loop.h"

namespace voronaut::testing {
namespace {

// The paper's frame mirrored (y = +Z) exchanges the rotors 2 and 4.
class Mirrored : public Regulator {
 public:
  explicit Mirrored(Regulator& inner) : inner_(inner) {}
  void reset(const VehicleState& state) override { inner_.reset(state); }
  Command regulate(const Setpoint& setpoint, const VehicleState& state) override {
    Command command = inner_.regulate(setpoint, state);
    std::swap(command.u[1], command.u[3]);
    return command;
  }

 private:
  Regulator& inner_;
};

TEST(PdRate, FlipsWithinHalfASecondInTheMirrorImageOfTheFrame) {
  const QuadrotorConfig vehicle;
  const Quadrotor model(vehicle);
  const auto guide = [](double, const VehicleState&) { return rest({10, 10, 1}, 2.5, {0, 1}); };
  PdRate right({}, vehicle, tilt_limited(20), kPeriod_s);
  Mirrored mirrored(right);
  const VehicleState start = model.at_rest({0, 0, 1}, {0, 1});
  EXPECT_EQ(flip_time_s(fly(model, right, start, 12, guide)), -1);
  const double flip_s = flip_time_s(fly(model, mirrored, start, 12, guide));
  EXPECT_GT(flip_s, 0);
  EXPECT_LT(flip_s, 0.5);
}

TEST(PdRate, RaisesTheRotorsThatThePapersPairsName) {
  // Body x along the paper's X, which is W's y: the pair 1-3 answers for y, the pair 2-4 for x.
  const QuadrotorConfig vehicle;
  const Quadrotor model(vehicle);
  PdRate regulator({}, vehicle, tilt_limited(20), kPeriod_s);
  const VehicleState at_rest = model.at_rest({0, 0, 1}, {0, 1});
  const auto command_towards = [&](double x, double y) {
    regulator.reset(at_rest);
    return regulator.regulate(pass({x, y, 1}, 1, {0, 1}), at_rest).u;
  };
  const auto along_x = command_towards(5, 0);
  EXPECT_GT(along_x[3], along_x[1]);
  EXPECT_DOUBLE_EQ(along_x[0], along_x[2]);
  const auto along_y = command_towards(0, 5);
  EXPECT_GT(along_y[2], along_y[0]);
  EXPECT_DOUBLE_EQ(along_y[1], along_y[3]);
}

TEST(PdRate, TurnsWithNoMoreThanItsShareOfTheRotorSpeed) {
  const QuadrotorConfig vehicle;
  const Quadrotor model(vehicle);
  PdRate regulator({}, vehicle, tilt_limited(20), kPeriod_s);
  const VehicleState at_rest = model.at_rest({0, 0, 1}, {1, 0});
  regulator.reset(at_rest);
  const auto u = regulator.regulate(rest({0, 0, 1}, 1, {-1, 0}), at_rest).u;
  const double share = 0.15 * vehicle.hover_rotor_speed_rad_s();
  EXPECT_NEAR((u[1] + u[3] - u[0] - u[2]) / 4, share, 1e-9);
}

TEST(PdRate, RecoversFromALargeRollAtRest) {
  const QuadrotorConfig vehicle;
  const Quadrotor model(vehicle);
  for (const double roll_deg : {30.0, 90.0, 135.0, 165.0}) {
    PdRate regulator({}, vehicle, tilt_limited(20), kPeriod_s);
    VehicleState start = model.at_rest({0, 0, 1}, {1, 0});
    start.q_world_body = Eigen::Quaterniond(Eigen::AngleAxisd(roll_deg * kDegree, Vec3::UnitX()));
    const auto states = fly(model, regulator, start, 8, [](double, const VehicleState&) {
      return rest({0, 0, 1}, 2.5);
    });
    EXPECT_LT(tilt_deg(states.back()), 10) << roll_deg;
  }
}

}  // namespace
}  // namespace voronaut::testing
