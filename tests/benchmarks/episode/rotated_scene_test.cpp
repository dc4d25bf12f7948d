#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/scenario/scenario_spec.h"

// One set of random scenes like the paper's, turned to each bearing: what the repaired planner does
// does not depend on where the axes point, up to rounding.
namespace voronaut {
namespace {

RunRecord flown(double bearing_rad, std::uint64_t seed) {
  const auto source = ConfigNode::parse(
      "{name: paper_scene, bearing_rad: " + number_text(bearing_rad) + "}", "scene");
  TrialSpec spec;
  spec.scenario = ScenarioSpec::generated({}, WorldGenerator::read(source)).instantiate(seed);
  spec.vehicle = find_vehicle("ideal");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"repaired", "ReactiveVoronoi", {{"preset", "repaired"}}};
  spec.flight.navigation = NavigationConfig::paper();
  spec.shortest_length_m = 14.2;
  return run_trial(spec, PlannerCatalog::built_in(), false).record;
}

TEST(RotatedScenes, AreFlownAlikeByTheRepairedPlannerAtEveryBearing) {
  int arrived = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const RunRecord straight = flown(0, seed);
    arrived += straight.outcome == Outcome::goal_reached ? 1 : 0;
    for (int eighth = 1; eighth < 8; ++eighth) {
      const RunRecord turned = flown(eighth * std::numbers::pi / 4, seed);
      EXPECT_EQ(turned.outcome, straight.outcome) << "seed " << seed << ", eighth " << eighth;
      EXPECT_EQ(turned.modes, straight.modes) << "seed " << seed << ", eighth " << eighth;
      EXPECT_NEAR(turned.path_length_m, straight.path_length_m, 1e-6)
          << "seed " << seed << ", eighth " << eighth;
      EXPECT_NEAR(turned.clearance_smallest_m, straight.clearance_smallest_m, 1e-6)
          << "seed " << seed << ", eighth " << eighth;
    }
  }
  EXPECT_GE(arrived, 10);
}

}  // namespace
}  // namespace voronaut
