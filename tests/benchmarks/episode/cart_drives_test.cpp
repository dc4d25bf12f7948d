#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/suite/shortest_references.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/world.h"

// What the executive does for a vehicle that looks where it drives.
namespace voronaut {
namespace {

TrialSpec cart_trial(const std::string& scenario, const std::string& navigation) {
  static const PlannerCatalog planners = PlannerCatalog::built_in();
  const SuiteConfig suite = read_suite(
      ConfigNode::parse("suite: s\nscenarios: [{name: a, " + scenario +
                            "}]\nvehicles: [{name: cart, params: {planning_clearance_m: 0.37}}]\n"
                            "planners: [VoronoiRoadmap]\n"
                            "navigation: {preset: paper, yaw_policy: path, " +
                            navigation + "}\n",
                        "s.yaml"),
      "", planners);
  TrialSpec spec = SuiteTrials(suite).next()->spec;
  ShortestReferences::exact().add_to(spec);
  return spec;
}

TEST(CartDrive, LooksAroundOnTheSpotAndThenLooksWhereItDrives) {
  const TrialSpec spec = cart_trial("generator: {name: u_trap}",
                                    "look_around: true, recovery: true, "
                                    "speed_rule: stopping_distance");
  Flight flight(spec, PlannerCatalog::built_in(), false);
  const EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached) << log.verdict.reason;
  EXPECT_GT(log.departure_s, 2);
  double backwards_m_s = 0;
  for (const Tick& tick : log.ticks) {
    const Vec2 p = tick.state.p_world.head<2>();
    const Vec2 v = tick.state.v_world.head<2>();
    if (tick.t_s < log.departure_s) {
      EXPECT_LT((p - spec.scenario.start_world).norm(), 0.02);
    }
    EXPECT_LT(std::abs(cross(tick.state.heading_world(), v)), 1e-12);
    EXPECT_EQ(tick.state.p_world.z(), 0);
    backwards_m_s = std::min(backwards_m_s, tick.state.heading_world().dot(v));
  }
  EXPECT_GT(backwards_m_s, -0.05);
}

// Never finds anything.
class Clueless : public ompl::base::Planner {
 public:
  explicit Clueless(const ompl::base::SpaceInformationPtr& si) : Planner(si, "Clueless") {}
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition&) override {
    return ompl::base::PlannerStatus::TIMEOUT;
  }
};

TEST(CartDrive, BacksOffByTurningRoundAndDrivingAway) {
  TrialSpec spec = cart_trial(
      "world: {circles: [[1.3, 0, 1]]}, bounds: [[-5, -5], [9, 5]], start: [0, 0], goal: [5, 0]",
      "recovery: true");
  spec.planner = {"Clueless", "Clueless", {}};
  PlannerCatalog planners = PlannerCatalog::built_in();
  planners.add({"Clueless", "never finds anything", {}, [](const auto& si) {
                  return std::make_shared<Clueless>(si);
                }});
  spec.flight.loop.stuck_after_s = 6;  // 1.5 s until it is a stall, 4 s for backing off
  Flight flight(spec, planners, false);
  const EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::stuck);
  EXPECT_TRUE(std::ranges::any_of(log.scans, [](const ScanEvent& event) {
    return event.executive == ExecutiveState::backing_off;
  }));
  EXPECT_GT(clearance_smallest_m(log.ticks), 0.28) << "it turns on the spot before it drives";
  EXPECT_GT(log.ticks.back().clearance_m, 0.4);
}

TEST(CartDrive, IsGovernedByArcs) {
  TrialSpec spec = cart_trial("generator: {name: u_trap}", "recovery: true");
  spec.flight.navigation.governor = true;
  Flight flight(spec, PlannerCatalog::built_in(), false);
  const EpisodeLog log = fly(flight);
  EXPECT_NE(log.verdict.outcome, Outcome::collision);
  for (const auto& scan : log.scans)
    EXPECT_TRUE(std::holds_alternative<ArcCommand>(scan.setpoint.motion));
}

}  // namespace
}  // namespace voronaut
