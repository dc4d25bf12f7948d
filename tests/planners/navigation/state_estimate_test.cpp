#include "voronaut/planners/navigation/state_estimate.h"

#include <cmath>
#include <deque>

#include <gtest/gtest.h>

#include "voronaut/dynamics/catalog.h"
#include "voronaut/dynamics/heading.h"
#include "voronaut/environments/random.h"

namespace voronaut {
namespace {

constexpr double kPeriod_s = 0.01;

Command any_command(const Command& hold, Random& random) {
  Command command = hold;
  for (double& number : command.u) number += random.uniform(-1, 1);
  return command;
}

StateEstimate estimate_of(const DeclaredErrors& errors, const Model& model) {
  return StateEstimate(
      errors,
      [&model](const VehicleState& state, const Command& command) {
        return model.step(state, command, kPeriod_s);
      },
      model.hold(), kPeriod_s);
}

// A drive in curves and the poses told of it. What lags changes its speeds evenly from step to
// step, as dead reckoning takes them to.
struct Drive {
  std::unique_ptr<Model> model = make_model(UnicycleConfig{.drive_lag_s = 0.1});
  VehicleState state = model->at_rest({0, 0, 0}, {1, 0});
  int steps = 0;

  void step() {
    const double turn_rad_s = 2 * std::sin(0.02 * steps++);
    state = model->step(state, Command{{1.5, turn_rad_s, 0, 0}}, kPeriod_s);
  }
  VehicleState told(double sigma_m, double sigma_rad, Random& random) const {
    VehicleState told = state;
    for (const int axis : {0, 1}) told.p_world[axis] += sigma_m * random.normal();
    const Eigen::AngleAxisd turn(sigma_rad * random.normal(), Vec3::UnitZ());
    told.q_world_body = turn * told.q_world_body;
    told.v_world = turn * told.v_world;
    return told;
  }
};

TEST(StateEstimate, IsWhatIsToldWhereNothingIsDeclared) {
  Drive drive;
  Random random(1);
  StateEstimate estimate = estimate_of({}, *drive.model);
  for (int i = 0; i < 50; ++i) {
    const VehicleState told = drive.told(0.1, 0.1, random);
    estimate.take(told);
    for (const VehicleState& state : {estimate.now(), estimate.when_it_acts()}) {
      EXPECT_EQ(state.p_world, told.p_world);
      EXPECT_EQ(state.q_world_body.coeffs(), told.q_world_body.coeffs());
    }
    estimate.command(any_command({}, random));
    drive.step();
  }
}

TEST(StateEstimate, KnowsWhereEveryVehicleIsWhenACommandActs) {
  for (const std::string& name : vehicle_names()) {
    const VehicleSpec spec = find_vehicle(name);
    const auto model = make_model(spec.model);
    Random random(2);
    for (const int late_steps : {0, 1, 5}) {
      StateEstimate estimate = estimate_of({.latency_s = late_steps * kPeriod_s}, *model);
      VehicleState state = model->at_rest({0, 0, 1}, {1, 0});
      std::deque<Command> under_way(static_cast<std::size_t>(late_steps), model->hold());
      std::deque<Vec3> predicted;
      for (int i = 0; i < 60; ++i) {
        estimate.take(state);
        predicted.push_back(estimate.when_it_acts().p_world);
        if (predicted.size() > static_cast<std::size_t>(late_steps)) {
          EXPECT_EQ(predicted.front(), state.p_world) << name << ", " << late_steps;
          predicted.pop_front();
        }
        const Command given = any_command(model->hold(), random);
        estimate.command(given);
        under_way.push_back(given);
        state = model->step(state, under_way.front(), kPeriod_s);
        under_way.pop_front();
      }
    }
  }
}

TEST(StateEstimate, LetsOfWhiteNoiseThroughWhatItsGainSays) {
  constexpr double kSigma_m = 0.02, kSigma_rad = 0.01;
  for (const double gain : {0.02, 0.1, 0.5}) {
    Drive drive;
    Random random(3);
    StateEstimate estimate = estimate_of({.pose_gain = gain}, *drive.model);
    double square_m2 = 0, square_rad2 = 0;
    int counted = 0;
    for (int i = 0; i < 20'000; ++i) {
      estimate.take(drive.told(kSigma_m, kSigma_rad, random));
      if (i > 1000) {
        ++counted;
        square_m2 += (estimate.now().p_world - drive.state.p_world).head<2>().squaredNorm() / 2;
        const double off_rad =
            heading_error_rad(drive.state.heading_world(), estimate.now().heading_world());
        square_rad2 += off_rad * off_rad;
        const Vec2 v = estimate.now().v_world.head<2>();
        EXPECT_NEAR(v.normalized().dot(estimate.now().heading_world()), 1, 1e-9);
      }
      drive.step();
    }
    const double share = std::sqrt(gain / (2 - gain));
    EXPECT_NEAR(std::sqrt(square_rad2 / counted) / kSigma_rad, share, 0.1 * share) << gain;
    // Dead reckoning along a heading that is off adds to it.
    const double drift = 1.5 * kPeriod_s / gain * kSigma_rad / kSigma_m * share;
    EXPECT_NEAR(std::sqrt(square_m2 / counted) / kSigma_m, share, 0.1 * share + drift) << gain;
  }
}

}  // namespace
}  // namespace voronaut
