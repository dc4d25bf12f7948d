#include "voronaut/benchmarks/episode/episode.h"

#include <map>

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/benchmarks/episode/episode_trace.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/environments/world.h"

namespace voronaut {
namespace {

const PlannerCatalog& planners() {
  static const PlannerCatalog catalog = PlannerCatalog::built_in();
  return catalog;
}

Scenario around(const std::vector<Circle>& circles, const Vec2& goal) {
  Scenario scenario;
  scenario.name = "test";
  scenario.world =
      std::make_shared<World>(Bounds{Vec2(-12, -12), Vec2(12, 12)}, Shapes{circles, {}, {}});
  scenario.goal_world = goal;
  scenario.start_heading = goal.normalized();
  return scenario;
}

TrialSpec trial(const Scenario& scenario, const std::string& vehicle_name,
                const std::string& planner, std::map<std::string, std::string> params = {}) {
  TrialSpec spec;
  spec.scenario = scenario;
  spec.vehicle = find_vehicle(vehicle_name);
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {planner, planner, std::move(params)};
  spec.flight.navigation = NavigationConfig::paper();
  spec.shortest_length_m = scenario.goal_world.norm();
  return spec;
}

TEST(Episode, RisesBeforeItSetsOff) {
  TrialSpec spec = trial(around({}, Vec2(8, 0)), "quadrotor", "RRTConnect");
  Flight flight(spec, planners(), false);
  const EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached);
  EXPECT_GT(log.departure_s, 1.0);
  for (const Tick& tick : log.ticks) {
    if (tick.t_s < log.departure_s) {
      EXPECT_LT(tick.state.p_world.head<2>().norm(), 0.05);
    }
  }
}

// Everything that a flight keeps begins where beams went.
TEST(Episode, FliesGovernedInBoundsUpToTwentyKilometres) {
  for (const double half_m : {25.0, 2'700.0, 10'000.0}) {
    Scenario scenario = around({{Vec2(5, 0.2), 0.5}, {Vec2(9, -0.3), 0.5}}, Vec2(15, 0));
    scenario.world = std::make_shared<World>(
        Bounds{Vec2::Constant(-half_m), Vec2::Constant(half_m)}, scenario.world->shapes());
    for (const std::string planner : {"VoronoiRoadmap", "ReactiveVoronoi", "PotentialField"}) {
      TrialSpec spec = trial(scenario, "ideal", planner);
      if (planner == "ReactiveVoronoi") spec.planner.params = {{"preset", "repaired"}};
      spec.flight.navigation.governor = spec.flight.navigation.look_around = true;
      const RunRecord record = run_trial(spec, planners(), false).record;
      EXPECT_EQ(record.outcome, Outcome::goal_reached) << planner << ", " << half_m << " m";
      EXPECT_GT(record.replans, 1) << "nothing was in the way";
    }
  }
}

TEST(Episode, PlansOnceWhereNothingIsInTheWayAndOnEveryScanIfReactive) {
  const Scenario open = around({}, Vec2(8, 0));
  EXPECT_EQ(run_trial(trial(open, "ideal", "RRTConnect"), planners(), false).record.replans, 1);
  const RunRecord reactive =
      run_trial(trial(open, "ideal", "ReactiveVoronoi", {{"preset", "repaired"}}), planners(),
                false)
          .record;
  EXPECT_GT(reactive.replans, 50);
}

TEST(Episode, TheSameTrialIsTheSameFlightBitForBit) {
  TrialSpec spec = trial(around({{Vec2(4, 0.2), 0.5}}, Vec2(8, 0)), "quadrotor", "ReactiveVoronoi",
                         {{"preset", "repaired"}});
  spec.flight.range_finder.noise_sigma_m = 0.02;
  const RunRecord first = run_trial(spec, planners(), false).record;
  const RunRecord again = run_trial(spec, planners(), true).record;
  EXPECT_EQ(first.state_digest, again.state_digest);
  spec.planner_seed = 2;
  EXPECT_NE(first.state_digest, run_trial(spec, planners(), false).record.state_digest);
}

TEST(Episode, ACommandActsOneVehicleStepAfterItIsGiven) {
  TrialSpec spec = trial(around({}, Vec2(8, 0)), "ideal", "RRTConnect");
  spec.scenario.start_height_m = 1;
  Flight flight(spec, planners(), false);
  const EpisodeLog log = fly(flight);
  // At height from the first tick on: planned at t = 0, so the first push acts in the second step.
  EXPECT_EQ(log.ticks[1].state.v_world.norm(), 0);
  EXPECT_GT(log.ticks[2].state.v_world.norm(), 0);
}

TEST(Episode, TouchingAtTheStartIsInvalidAndNotACollision) {
  const RunRecord record =
      run_trial(trial(around({{Vec2(0.5, 0), 0.3}}, Vec2(8, 0)), "quadrotor", "RRTConnect"),
                planners(), false)
          .record;
  EXPECT_EQ(record.outcome, Outcome::invalid);
  EXPECT_FALSE(record.reason.empty());
}

TEST(Episode, ATraceHasAFrameForEveryScanAndTheEnd) {
  const TrialSpec spec = trial(around({{Vec2(4, 0.2), 0.5}}, Vec2(8, 0)), "quadrotor",
                               "ReactiveVoronoi", {{"preset", "repaired"}});
  const TrialResult result = run_trial(spec, planners(), true);
  ASSERT_TRUE(result.trace);
  const Trace& trace = *result.trace;
  ASSERT_GT(trace.frames.size(), 100U);
  EXPECT_NEAR(trace.frames[1].t_s - trace.frames[0].t_s, 0.05, 1e-12);
  EXPECT_EQ(trace.frames.back().known_points, trace.known_points.size());
  EXPECT_EQ(trace.known_points.size(), static_cast<std::size_t>(result.record.map_points));
  EXPECT_EQ(trace.cluster_of.size(), trace.known_points.size());
  EXPECT_EQ(trace.frames.front().range_m.size(), 91U);
}

TEST(Episode, ATraceNamesWhatEndedEachSolve) {
  TrialSpec spec = trial(around({{Vec2(4, 0.2), 0.5}}, Vec2(8, 0)), "quadrotor", "RRTstar");
  spec.flight.budget.state_checks = 300;
  const TrialResult result = run_trial(spec, planners(), true);
  ASSERT_TRUE(result.trace);
  std::map<std::string, std::int64_t> solves;
  for (const TraceFrame& frame : result.trace->frames)
    if (frame.solve_end >= 0)
      ++solves[result.trace->solve_ends[static_cast<std::size_t>(frame.solve_end)]];
  EXPECT_GT(result.record.stops_state_checks, 0);
  EXPECT_EQ(solves["state_checks"], result.record.stops_state_checks);
  EXPECT_EQ(solves["planner"], result.record.replans - result.record.budget_stops);
}

TEST(Episode, ATraceOfAGovernedFlightTellsWhatGovernorAndPlannerThought) {
  TrialSpec spec =
      trial(around({{Vec2(4, 0.2), 0.5}, {Vec2(4.4, -1), 0.5}, {Vec2(7, 0), 0.4}}, Vec2(9, 0)),
            "quadrotor", "RRTConnect");
  spec.flight.range_finder.max_range_m = 2.5;
  spec.flight.navigation.governor = true;
  spec.flight.navigation.look_around = true;
  spec.flight.navigation.yaw_policy = YawReference::path;
  Flight flight(spec, planners(), true);
  const EpisodeLog log = fly(flight);
  const Trace trace = trace_of(spec, log, flight.navigator.known());
  ASSERT_EQ(trace.frames.size(), log.scans.size() + 1);
  ASSERT_GT(trace.searches, 1) << log.verdict.reason;
  EXPECT_EQ(trace.searches, log.replans);
  EXPECT_EQ(trace.kept_searches, trace.searches);
  std::size_t tubes = 0;
  int asked = 0;
  for (std::size_t k = 0; k < log.scans.size(); ++k) {
    EXPECT_EQ(trace.frames[k].speed_scale, log.scans[k].speed_scale);
    EXPECT_EQ(trace.frames[k].tube.size(), log.scans[k].tube.size());
    EXPECT_EQ(trace.frames[k].search, log.scans[k].search);
    EXPECT_LE(trace.frames[k].known_points, trace.known_points.size());
    tubes += trace.frames[k].tube.empty() ? 0U : 1U;
    asked += trace.frames[k].replan >= 0 ? 1 : 0;
  }
  EXPECT_GT(tubes, 50U);
  EXPECT_EQ(asked, trace.searches);
}

// A world turned about the start by a quarter gives the flight turned by a quarter: nothing in the
// loop prefers an axis, once the planner does not.
TEST(Episode, TurningTheWorldTurnsTheFlightOfTheRepairedPlanner) {
  const std::vector<Circle> circles{
      {Vec2(3, 0.3), 0.5}, {Vec2(6, -1.5), 1.0}, {Vec2(6.5, 1.4), 0.5}};
  std::vector<Circle> turned;
  for (const Circle& c : circles) turned.push_back({left_of(c.center), c.radius_m});
  const auto flown = [](const std::vector<Circle>& world, const Vec2& goal) {
    return run_trial(
               trial(around(world, goal), "ideal", "ReactiveVoronoi", {{"preset", "repaired"}}),
               planners(), false)
        .record;
  };
  const RunRecord straight = flown(circles, Vec2(9, 0));
  const RunRecord quarter = flown(turned, Vec2(0, 9));
  EXPECT_EQ(straight.outcome, Outcome::goal_reached);
  EXPECT_EQ(quarter.outcome, Outcome::goal_reached);
  EXPECT_EQ(straight.modes, quarter.modes);
  EXPECT_NEAR(straight.path_length_m, quarter.path_length_m, 1e-6);
  EXPECT_NEAR(straight.clearance_smallest_m, quarter.clearance_smallest_m, 1e-6);
}

// Says that its start is not valid so many times, and flies straight to the goal after that.
class Refuser : public ompl::base::Planner {
 public:
  Refuser(const ompl::base::SpaceInformationPtr& si, int refusals)
      : Planner(si, "Refuser"), refusals_(refusals) {}

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition&) override {
    if (refusals_-- > 0) return ompl::base::PlannerStatus::INVALID_START;
    pdef_->addSolutionPath(std::make_shared<ompl::geometric::PathGeometric>(
                               si_, pdef_->getStartState(0),
                               pdef_->getGoal()->as<ompl::base::GoalState>()->getState()),
                           false, 0, getName());
    return ompl::base::PlannerStatus::EXACT_SOLUTION;
  }

 private:
  int refusals_;
};

RunRecord flown_by_a_refuser(int refusals) {
  PlannerCatalog catalog = PlannerCatalog::built_in();
  catalog.add({"Refuser", "refuses its start", {}, [refusals](const auto& si) {
                 return std::make_shared<Refuser>(si, refusals);
               }});
  return run_trial(trial(around({}, Vec2(8, 0)), "ideal", "Refuser"), catalog, false).record;
}

TEST(Episode, APlannerThatRefusesItsStartIsAskedAgain) {
  const RunRecord record = flown_by_a_refuser(3);
  EXPECT_EQ(record.outcome, Outcome::goal_reached) << record.reason;
  EXPECT_EQ(record.replans, 4);
}

TEST(Episode, APlannerThatRefusesForEverHasProvedNothing) {
  const RunRecord record = flown_by_a_refuser(1'000'000);
  EXPECT_EQ(record.outcome, Outcome::stuck);
  EXPECT_TRUE(record.reason.ends_with("the planner refused: Invalid start")) << record.reason;
}

TEST(Episode, AGoalWithoutAPlaceIsInfeasibleWhoeverPlans) {
  const std::vector<Circle> around_the_goal{{Vec2(8, 0), 0.2}};
  const RunRecord record =
      run_trial(trial(around(around_the_goal, Vec2(8, 0)), "ideal", "RRTConnect"), planners(),
                false)
          .record;
  EXPECT_EQ(record.outcome, Outcome::infeasible);
  EXPECT_EQ(record.reason, "no place at the goal keeps the clearance from what is known");
}

}  // namespace
}  // namespace voronaut
