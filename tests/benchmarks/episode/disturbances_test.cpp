#include "voronaut/benchmarks/episode/disturbances.h"

#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"

namespace voronaut {
namespace {

constexpr double kPeriod_s = 0.01;

TEST(Disturbances, LetACommandActOneStepLaterAndTheLatency) {
  for (const int late_steps : {0, 1, 5}) {
    Disturbances disturbances({.latency_s = late_steps * kPeriod_s}, Command{{-1, 0, 0, 0}},
                              kPeriod_s, 1);
    for (int step = 0; step < 20; ++step) {
      const int given_at = step - 1 - late_steps;
      EXPECT_EQ(disturbances.acting().u[0], given_at < 0 ? -1 : given_at) << late_steps;
      disturbances.command(Command{{static_cast<double>(step), 0, 0, 0}});
    }
  }
}

TEST(Disturbances, MakeOfEachNumberMoreOrLessByTheirShare) {
  int more = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Disturbances disturbances({.gain_error = 0.1}, {}, kPeriod_s, seed);
    disturbances.command(Command{{2, 2, 2, 2}});
    for (const double acting : disturbances.acting().u) {
      EXPECT_NEAR(std::abs(acting - 2), 0.2, 1e-12);
      more += acting > 2 ? 1 : 0;
    }
  }
  EXPECT_NEAR(more, 200, 40);
}

TEST(Disturbances, TellAPoseWithNoiseAndVelocitiesAsTheBodyHasThem) {
  Disturbances disturbances({.position_sigma_m = 0.01, .heading_sigma_rad = 0.02}, {}, kPeriod_s,
                            1);
  VehicleState state;
  state.v_world = {2, 0, 0};
  double x2 = 0, y2 = 0, turn2 = 0;
  constexpr int kTimes = 20'000;
  for (int i = 0; i < kTimes; ++i) {
    const VehicleState told = disturbances.told(state);
    x2 += told.p_world.x() * told.p_world.x();
    y2 += told.p_world.y() * told.p_world.y();
    const Eigen::Vector2d heading = told.heading_world();
    turn2 += heading.y() * heading.y();
    EXPECT_NEAR(heading.dot(told.v_world.head<2>()), 2, 1e-12);
  }
  EXPECT_NEAR(std::sqrt(x2 / kTimes), 0.01, 2e-4);
  EXPECT_NEAR(std::sqrt(y2 / kTimes), 0.01, 2e-4);
  EXPECT_NEAR(std::sqrt(turn2 / kTimes), 0.02, 4e-4);
}

// Every trial of forests driven by a jackal, governed.
std::vector<TrialSpec> drives(const std::string& rest) {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  const SuiteConfig suite = read_suite(
      ConfigNode::parse(
          "suite: s\nseed: 3\nrepetitions: 20\nscenarios: [{generator: forest, "
          "density_per_m2: 0.2}]\nvehicles: [{name: jackal, model: {drive_lag_s: 0.1}}]\n"
          "planners: [VoronoiRoadmap]\nnavigation: {governor: true, yaw_policy: path, recovery: "
          "true, look_around: true}\n" +
              rest,
          "s.yaml"),
      "", planners);
  std::vector<TrialSpec> specs;
  SuiteTrials trials(suite);
  ShortestReferences references = ShortestReferences::exact();
  while (auto trial = trials.next()) {
    references.add_to(trial->spec);
    specs.push_back(trial->spec);
  }
  return specs;
}

// How many of them touch something.
int contacts(const std::string& rest) {
  int contacts = 0;
  for (const TrialSpec& spec : drives(rest)) {
    Flight flight(spec, PlannerCatalog::built_in(), false);
    contacts += fly(flight).verdict.outcome == Outcome::collision ? 1 : 0;
  }
  return contacts;
}

TEST(Disturbances, DoNoHarmOnceTheyAreDeclared) {
  const std::string disturbed =
      "range_finder: {noise_sigma_m: 0.01, field_of_view_rad: 4.7, rays: 360, max_range_m: 10}\n"
      "disturbances: {latency_s: 0.1, gain_error: 0.1, position_sigma_m: 0.02, "
      "heading_sigma_rad: 0.02}\n";
  EXPECT_EQ(
      contacts(disturbed + "declared_errors: {latency_s: 0.1, pose_gain: 0.05, range_m: 0.01, "
                           "position_m: 0.015, heading_rad: 0.015, stop_per_speed_s: 0.02}\n"),
      0);
  EXPECT_GT(contacts(disturbed), 0) << "nothing is shown";
}

TEST(Disturbances, NameATrialOnlyWhereThereAreAny) {
  const std::string without = drives("").front().trial_id;
  EXPECT_EQ(drives("disturbances: {latency_s: 0}\n").front().trial_id, without);
  const std::string late = drives("disturbances: {latency_s: 0.02}\n").front().trial_id;
  EXPECT_NE(late, without);
  EXPECT_NE(drives("declared_errors: {latency_s: 0.02}\n").front().trial_id, without);
  EXPECT_NE(drives("declared_errors: {latency_s: 0.02}\n").front().trial_id, late);
}

}  // namespace
}  // namespace voronaut
