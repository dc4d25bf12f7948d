#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/shortest_references.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/tests/benchmarks/episode/every_trial.h"

// Everything on wheels under the governor, from sensing to contact.
namespace voronaut {
namespace {

constexpr const char* kWheeled[] = {"unicycle", "jackal", "cart"};

// Sees all around, for what cannot turn on the spot to look.
constexpr const char* kAllAround =
    "range_finder: {field_of_view_rad: 6.283185307179586, rays: 360}\n";

// Every trial of a suite with VoronoiRoadmap, governed.
std::vector<TrialSpec> governed(const std::string& vehicle, const std::string& scenario,
                                int repetitions, const std::string& rest = "") {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  const SuiteConfig suite = read_suite(
      ConfigNode::parse("suite: s\nseed: 5\nrepetitions: " + std::to_string(repetitions) +
                            "\nscenarios: [" + scenario + "]\nvehicles: [" + vehicle +
                            "]\nplanners: [VoronoiRoadmap]\nnavigation: {governor: true, "
                            "look_around: true, yaw_policy: path, recovery: true}\n" +
                            rest,
                        "s.yaml"),
      "", planners);
  return every_trial(suite);
}

EpisodeLog drive(const TrialSpec& spec) {
  Flight flight(spec, PlannerCatalog::built_in(), false);
  return fly(flight);
}

// How far it turns in all, to either side, once it has looked around.
double turned_rad(const EpisodeLog& log) {
  double turned_rad = 0;
  for (std::size_t i = 0; i + 1 < log.ticks.size(); ++i) {
    if (log.ticks[i].t_s < log.departure_s) continue;
    turned_rad +=
        std::abs(log.ticks[i].state.w_body.z()) * (log.ticks[i + 1].t_s - log.ticks[i].t_s);
  }
  return turned_rad;
}

TEST(GovernedWheels, ArriveThroughForestsWithoutAContact) {
  for (const char* vehicle : kWheeled) {
    for (const TrialSpec& spec : governed(
             vehicle, "{name: f, generator: {name: forest, side_m: 10, density_per_m2: 0.1}}", 6)) {
      const EpisodeLog log = drive(spec);
      EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached)
          << vehicle << " " << spec.scenario.name << ": " << log.verdict.reason;
    }
  }
}

TEST(GovernedWheels, ArriveWithACarThatBacksUpOutOfTraps) {
  int backed_up = 0;
  for (const char* scenario :
       {"{name: f, generator: {name: forest, side_m: 10, density_per_m2: 0.1}}",
        "{name: u, generator: {name: u_trap}}"}) {
    for (const TrialSpec& spec : governed("car", scenario, 5, kAllAround)) {
      const EpisodeLog log = drive(spec);
      EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached)
          << scenario << ": " << log.verdict.reason;
      const auto backwards = [](const Tick& tick) {
        return tick.state.heading_world().dot(tick.state.v_world.head<2>()) < -0.1;
      };
      backed_up += std::ranges::any_of(log.ticks, backwards) ? 1 : 0;
    }
  }
  EXPECT_GT(backed_up, 0);
}

struct Passage {
  const char* vehicle;
  const char* gap_m;
};

// As wide as planners plan for and a centimetre or two more. There a vehicle that turns away from
// either side in turn swings about its path until it stands, then turns again: 27 rad in all. What
// looks at a wall that it stands beside, and turns back, never gets on.
TEST(GovernedWheels, DriveThroughANarrowGapWithoutTurningToAndFro) {
  for (const auto& [vehicle, gap_m] :
       {Passage{"unicycle", "0.60"}, Passage{"jackal", "0.72"}, Passage{"cart", "0.81"}}) {
    double all_turned_rad = 0;
    constexpr int kRepetitions = 12;
    for (const TrialSpec& spec :
         governed(vehicle,
                  std::string("{name: g, generator: {name: narrow_gaps, gap_m: ") + gap_m + "}}",
                  kRepetitions)) {
      const EpisodeLog log = drive(spec);
      EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached)
          << vehicle << ": " << log.verdict.reason;
      EXPECT_LT(log.ticks.back().t_s, 25) << vehicle;
      all_turned_rad += turned_rad(log);
    }
    EXPECT_LE(all_turned_rad / kRepetitions, 7) << vehicle;
  }
}

// The hull of a Jackal: 0.416 m wide, but the disc that holds it measures 0.62 m.
std::string jackal_hull(const std::string& params, const std::string& planned = "") {
  return "{name: jackal, params: {" + params +
         "}, footprint: {polygon: [[0.229, 0.208], [-0.229, 0.208], [-0.229, -0.208], [0.229, "
         "-0.208]]" +
         planned + "}}";
}
const char* const kSeesItsSides =
    "range_finder: {field_of_view_rad: 4.712388980384690, rays: 360, max_range_m: 5}\n";

TEST(GovernedPolygon, PassesGapsThatTheDiscAboutItDoesNotFitThrough) {
  const std::string narrow = "{name: g, generator: {name: narrow_gaps, gap_m: 0.58}}";
  int passed = 0;
  for (const TrialSpec& spec :
       governed(jackal_hull("planning_clearance_m: 0.27", ", planned_radius_m: 0.21"), narrow, 6,
                kSeesItsSides)) {
    EXPECT_FALSE(std::isfinite(ShortestReferences::exact_length_m(spec.scenario, 0.309)));
    const EpisodeLog log = drive(spec);
    EXPECT_GT(log.body_clearance_smallest_m, 0.01);
    if (log.verdict.outcome != Outcome::goal_reached) continue;
    ++passed;
    EXPECT_LT(log.body_clearance_smallest_m, 0.2) << "0.29 m less half its width";
  }
  EXPECT_GE(passed, 5)
      << "one in a hundred comes in at a slant and stands still (docs/vehicles.md)";
}

TEST(GovernedPolygon, TouchesNothingInForestsAndTraps) {
  for (const std::string& vehicle :
       {jackal_hull("planning_clearance_m: 0.35"),
        jackal_hull("planning_clearance_m: 0.27", ", planned_radius_m: 0.21")}) {
    for (const char* scenario :
         {"{name: f, generator: {name: forest, side_m: 10, density_per_m2: 0.15}}",
          "{name: u, generator: {name: u_trap}}"}) {
      for (const TrialSpec& spec : governed(vehicle, scenario, 4, kSeesItsSides)) {
        const EpisodeLog log = drive(spec);
        EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached)
            << vehicle << " " << scenario << ": " << log.verdict.reason;
        EXPECT_GT(log.body_clearance_smallest_m, 0);
      }
    }
  }
}

// Cells of known-free space as coarse as suffice for more room leave none: there it stands still.
TEST(GovernedFlight, PassesGapsThatAHandsWidthFitsBeside) {
  const Passage passages[] = {{"{name: ideal, params: {planning_clearance_m: 0.29}}", "0.60"},
                              {"{name: quadrotor, params: {planning_clearance_m: 0.31}}", "0.64"}};
  for (const auto& [vehicle, gap_m] : passages) {
    const std::string scenario =
        std::string("{name: g, generator: {name: narrow_gaps, gap_m: ") + gap_m + "}}";
    for (const TrialSpec& spec : governed(vehicle, scenario, 4)) {
      const EpisodeLog log = drive(spec);
      EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached)
          << vehicle << ": " << log.verdict.reason;
    }
  }
}

}  // namespace
}  // namespace voronaut
