#include "voronaut/benchmarks/episode/disturbances.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/tests/benchmarks/episode/every_trial.h"
#include "voronaut/tests/dynamics/track_distance.h"

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

// A jackal with the errors of barn-challenge-noise, but for those of its senses, under random arcs.
class DisturbedDrive {
 public:
  explicit DisturbedDrive(std::uint64_t seed)
      : response_(std::get<DriveResponse>(motion_response(law_, spec_, kPeriod_s))),
        model_(make_model(spec_.model)),
        regulator_(make_regulator(law_, spec_, kPeriod_s)),
        disturbances_({.latency_s = kLatency_s, .gain_error = 0.1}, {}, kPeriod_s, seed),
        estimate_(
            {.latency_s = kLatency_s},
            [this](const VehicleState& from, const Command& command) {
              return model_->step(from, command, kPeriod_s);
            },
            {}, kPeriod_s),
        state_(model_->at_rest({0, 0, 0}, {1, 0})),
        random_(seed) {
    regulator_->reset(state_);
    estimate_.take(state_);
  }
  DisturbedDrive(const DisturbedDrive&) = delete;

  void step(const ArcCommand& arc) {
    Setpoint setpoint;
    setpoint.motion = arc;
    const Command command = regulator_->regulate(setpoint, estimate_.when_it_acts());
    state_ = model_->step(state_, disturbances_.acting(), kPeriod_s);
    estimate_.command(command);
    disturbances_.command(command);
    estimate_.take(state_);
  }
  ArcCommand any_arc() {
    const double turn_rad = random_.uniform(-0.8, 0.8);
    const Vec2 way_m = random_.uniform(0.2, 2) * Vec2(std::cos(turn_rad), std::sin(turn_rad));
    return arc_towards({1, 0}, way_m, random_.uniform(0, 2), estimate_.now().v_world.norm(),
                       response_.limits);
  }
  // How far a stop from here strays from its prediction, beside what the vehicle promises, per
  // speed: the track is what the governor sweeps, from where the command begins to act.
  double stray_per_speed_s(const ArcCommand& before, const ArcCommand& command) {
    const DriveMotion motion = response_.motion_of(estimate_.when_it_acts());
    const double promised_m = response_.error_m(motion, command);
    const double fastest_m_s = std::max(std::abs(motion.v_m_s), std::abs(command.v_m_s));
    std::vector<Eigen::Vector2d> track;
    response_.predict_stop(motion, before, command, kHold_s, 0.05, track);
    const auto late_steps = static_cast<int>(std::lround(kLatency_s / kPeriod_s));
    double stray_m = 0;
    for (int i = 0; i < 200; ++i) {
      if (i >= late_steps)
        stray_m = std::max(stray_m, testing::distance_m(state_.p_world.head<2>(), track));
      step(i * kPeriod_s < kHold_s - 1e-9 ? command : ArcCommand{});
    }
    return (stray_m - promised_m) / fastest_m_s;
  }

  static constexpr double kLatency_s = 0.05, kHold_s = 0.02;

 private:
  static VehicleSpec with_lag() {
    VehicleSpec spec = find_vehicle("jackal");
    std::get<UnicycleConfig>(spec.model).drive_lag_s = 0.1;
    return spec;
  }

  VehicleSpec spec_ = with_lag();
  RegulatorConfig law_ = find_regulator(spec_.regulator);
  DriveResponse response_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Regulator> regulator_;
  Disturbances disturbances_;
  StateEstimate estimate_;
  VehicleState state_;
  Random random_;
};

TEST(Disturbances, LetStopsStrayByNoMoreThanTheSuiteOfBarnDeclares) {
  double largest_s = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    DisturbedDrive drive(seed);
    ArcCommand arc;
    for (int hold = 0; hold < 40; ++hold) {
      const ArcCommand before = arc;
      if (hold % 4 == 0) arc = drive.any_arc();
      if (hold == 39 && arc.v_m_s > 0.1)
        largest_s = std::max(largest_s, drive.stray_per_speed_s(before, arc));
      for (int i = 0; i < 2; ++i) drive.step(arc);
    }
  }
  EXPECT_LT(largest_s, 0.01);
  EXPECT_GT(largest_s, 0.002) << "it need not be declared";
}

constexpr const char* kForests = "{generator: {name: forest, density_per_m2: 0.2}}";

// Every trial of twenty repetitions driven by a jackal, governed.
std::vector<TrialSpec> drives(const std::string& rest, const std::string& scenario = kForests) {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  const SuiteConfig suite =
      read_suite(ConfigNode::parse(
                     "suite: s\nseed: 3\nrepetitions: 20\nrepeat: random\nscenarios: [" + scenario +
                         "]\nvehicles: [{name: jackal, params: {planning_clearance_m: 0.35}, "
                         "model: {drive_lag_s: 0.1}}]\nplanners: [VoronoiRoadmap]\n"
                         "navigation: {governor: true, yaw_policy: path, recovery: true, "
                         "look_around: true}\n" +
                         rest,
                     "s.yaml"),
                 "", planners);
  return every_trial(suite);
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

EpisodeLog drive_past(const std::string& circles, const std::string& declared) {
  const std::vector<TrialSpec> specs = drives(
      "declared_errors: {" + declared + "}\n",
      "{name: posts, start: [0, 0], goal: [6, 0], bounds: [[-2, -3], [8, 3]], world: {circles: [" +
          circles + "]}}");
  Flight flight(specs.front(), PlannerCatalog::built_in(), false);
  return fly(flight);
}

// A wall of posts with one gap, 0.39 m to either side of its middle.
std::string wall_with_gap() {
  std::string wall = "[3, 0.59, 0.2], [3, -0.59, 0.2]";
  for (const char* y : {"0.9", "1.2", "1.5", "1.8", "2.1", "2.4", "2.7", "3"})
    wall += ", [3, " + std::string(y) + ", 0.2], [3, -" + y + ", 0.2]";
  return wall;
}

double clearance_m(const EpisodeLog& log) {
  double smallest_m = 10;
  for (const Tick& tick : log.ticks) smallest_m = std::min(smallest_m, tick.clearance_m);
  return smallest_m;
}

// Where there is room for it; else less, as long as there is a way at all.
TEST(Disturbances, AreKeptMoreRoomForWherePlansHaveIt) {
  const std::string post = "[3, 0.1, 0.4]";
  EXPECT_LT(clearance_m(drive_past(post, "")), 0.4);
  EXPECT_GT(clearance_m(drive_past(post, "planning_room_m: 0.2")), 0.45);
  for (const char* room : {"planning_room_m: 0", "planning_room_m: 0.05", "planning_room_m: 0.2"}) {
    const EpisodeLog log = drive_past(wall_with_gap(), room);
    EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached) << room << ": " << log.verdict.reason;
  }
}

// A disc of 0.31 m and 0.04 m, once for where posts are and once for where the vehicle is.
TEST(Disturbances, CloseAGapToTheGovernorOnceTheyAreDeclaredAsWideAsItsRoom) {
  EXPECT_NE(drive_past(wall_with_gap(), "position_m: 0.04").verdict.outcome, Outcome::goal_reached);
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
