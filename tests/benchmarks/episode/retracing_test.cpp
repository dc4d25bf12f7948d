#include <algorithm>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/random.h"

// A world of the evidence in which the vehicle comes into a pocket through a passage a little
// narrower than 2 C_min, before it has seen both sides of it.
namespace voronaut {
namespace {

TrialSpec into_a_pocket() {
  const auto forest =
      ConfigNode::parse("{name: forest, side_m: 20, density_per_m2: 0.25}", "forest");
  TrialSpec spec;
  spec.scenario = ScenarioSpec::generated({}, WorldGenerator::read(forest))
                      .instantiate(derive_seed(104, {"forest-20m-0.25"}, 552));
  spec.vehicle = vehicle("quadrotor");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = regulator(spec.regulator_name);
  spec.planner = {"VoronoiRoadmap", "VoronoiRoadmap", {}};
  spec.navigation.governor = spec.navigation.look_around = spec.navigation.recovery = true;
  spec.navigation.gaze = Gaze::path;
  spec.shortest_length_m = 32;
  return spec;
}

TEST(Retracing, LeadsOutOfAPocketFromWhichNoPathExists) {
  const TrialSpec spec = into_a_pocket();
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  const EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached);
  EXPECT_TRUE(std::any_of(log.scans.begin(), log.scans.end(), [](const ScanEvent& scan) {
    return scan.executive == ExecutiveState::retracing;
  }));
}

TEST(Retracing, IsNoVerdictOfTheWorldWhereRecoveryIsOff) {
  TrialSpec spec = into_a_pocket();
  spec.navigation.recovery = false;
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  EXPECT_NE(fly(flight).verdict.outcome, Outcome::infeasible);
}

}  // namespace
}  // namespace voronaut
