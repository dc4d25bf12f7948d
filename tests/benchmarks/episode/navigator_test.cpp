#include "voronaut/planners/navigation/navigator.h"

#include <gtest/gtest.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/world.h"

// A navigator knows nothing but what it is told: shown the scans and states of a flight once more,
// it says what it said then.
namespace voronaut {
namespace {

TrialSpec among_posts(const std::string& planner, std::map<std::string, std::string> params = {}) {
  const std::vector<Circle> posts{
      {Vec2(3, 0.3), 0.5}, {Vec2(5.5, -1.2), 0.6}, {Vec2(6, 1.4), 0.5}, {Vec2(8, 0.2), 0.4}};
  TrialSpec spec;
  spec.scenario.name = "posts";
  spec.scenario.world =
      std::make_shared<World>(Bounds{Vec2(-3, -6), Vec2(14, 6)}, Shapes{posts, {}, {}});
  spec.scenario.goal_world = Vec2(11, 0);
  spec.vehicle = find_vehicle("quadrotor");
  spec.vehicle.planning_clearance_m = 0.4;  // for what is not governed
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {planner, planner, std::move(params)};
  spec.flight.range_finder.noise_sigma_m = 0.005;
  spec.flight.navigation = NavigationConfig::paper();
  spec.shortest_length_m = 11;
  return spec;
}

TrialSpec governed() {
  TrialSpec spec = among_posts("VoronoiRoadmap");
  spec.flight.navigation.governor = spec.flight.navigation.look_around =
      spec.flight.navigation.recovery = true;
  spec.flight.navigation.yaw_policy = YawReference::path;
  return spec;
}

TrialSpec reactive() {
  TrialSpec spec = among_posts("ReactiveVoronoi", {{"preset", "repaired"}});
  spec.flight.navigation.speed_rule = SpeedRule::stopping_distance;
  return spec;
}

// Keeps the scans beside the recorder.
class Tape : public NavigationObserver {
 public:
  explicit Tape(Flight& flight) : flight_(flight) { flight.navigator.observe(this); }
  void stage_begins(Stage stage) override { flight_.recorder.stage_begins(stage); }
  void stage_ends(Stage stage) override {
    if (stage == Stage::mapping) scans.push_back(flight_.navigator.scan());
    flight_.recorder.stage_ends(stage);
  }
  std::vector<Scan> scans;

 private:
  Flight& flight_;
};

// Which mode a setpoint is in, and every number in it.
std::vector<double> numbers_of(const Setpoint& setpoint) {
  std::vector<double> all{static_cast<double>(setpoint.motion.index()), setpoint.height_m,
                          setpoint.heading_world.x(), setpoint.heading_world.y(),
                          setpoint.yaw_rate_rad_s};
  const auto add = [&all](const Vec2& v) { all.insert(all.end(), {v.x(), v.y()}); };
  if (const auto* pass = std::get_if<PassTarget>(&setpoint.motion)) {
    add(pass->p_world);
    all.push_back(pass->speed_limit_m_s);
    if (pass->segment) add(pass->segment->start);
    if (pass->segment) add(pass->segment->end);
  } else if (const auto* rest = std::get_if<RestAtTarget>(&setpoint.motion)) {
    add(rest->p_world);
    all.push_back(rest->speed_limit_m_s);
  } else {
    add(std::get<VelocityCommand>(setpoint.motion).v_world_m_s);
  }
  return all;
}

// How many of the recorded setpoints a navigator of this configuration gives again, of how many.
std::pair<std::size_t, std::size_t> given_again(const TrialSpec& spec,
                                                const NavigatorConfig& config) {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Flight flight(spec, planners, false);
  Tape tape(flight);
  const EpisodeLog log = fly(flight);
  EXPECT_EQ(log.verdict.outcome, Outcome::goal_reached) << log.verdict.reason;
  EXPECT_EQ(tape.scans.size(), log.scans.size());

  Navigator again(config, planners);
  std::size_t next = 0, same = 0;
  for (std::size_t tick = 0; tick < log.ticks.size() && next < log.scans.size(); ++tick) {
    const auto& [t_s, state, clearance_m] = log.ticks[tick];
    if (log.scans[next].tick != tick) {
      again.steer(state, t_s);
      continue;
    }
    const Setpoint setpoint = again.update(tape.scans[next], state, t_s);
    same += numbers_of(setpoint) == numbers_of(log.scans[next].setpoint) ? 1U : 0U;
    ++next;
  }
  return {same, log.scans.size()};
}

TEST(Navigator, GivesTheSetpointsOfAFlightAgainBitForBit) {
  for (const TrialSpec& spec : {governed(), reactive()}) {
    const auto [same, all] = given_again(spec, navigator_config(spec));
    EXPECT_GT(all, 100U);
    EXPECT_EQ(same, all) << spec.planner.name;
  }
}

TEST(Navigator, GivesOthersWhereItIsToldSomethingElse) {
  const TrialSpec spec = reactive();
  NavigatorConfig config = navigator_config(spec);
  config.mission.goal_world.y() += 1e-6;
  const auto [same, all] = given_again(spec, config);
  EXPECT_LT(same, all);
}

TEST(Navigator, RefusesAGovernorForAVehicleOfWhichNobodySaysHowItStops) {
  NavigatorConfig config = navigator_config(governed());
  config.vehicle.motion_response.reset();
  EXPECT_THROW(Navigator(config, PlannerCatalog::built_in()), std::invalid_argument);
}

TEST(Navigator, RefusesAGovernorThatAsksForVelocitiesOfWhatDrivesAlongItsHeading) {
  NavigatorConfig config = navigator_config(governed());
  config.vehicle.steering = Steering::along_heading;
  EXPECT_THROW(Navigator(config, PlannerCatalog::built_in()), std::invalid_argument);
}

TEST(Navigator, RefusesAPlannerThatNobodyKnows) {
  NavigatorConfig config = navigator_config(reactive());
  config.planner = "Nobody";
  EXPECT_THROW(Navigator(config, PlannerCatalog::built_in()), std::invalid_argument);
}

// On wheels, a hand's width beside a wall that runs along its way and out of its view. Cells on the
// wall are unknown for ever: it turns away from them and not to them.
TEST(Navigator, DoesNotTurnToLookAtAWallThatItHasSeen) {
  TrialSpec spec = governed();
  spec.vehicle = find_vehicle("unicycle");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  Shapes wall;
  wall.segments.push_back({Vec2(-2, -0.262), Vec2(8, -0.262)});
  spec.scenario.world = std::make_shared<World>(Bounds{Vec2(-3, -6), Vec2(14, 6)}, wall);
  spec.vehicle.planning_clearance_m = 0.26;  // a path along the wall keeps that
  spec.scenario.cruise_height_m = 0;
  spec.flight.navigation.look_around = false;
  spec.flight.range_finder.noise_sigma_m = 0;
  Navigator navigator(navigator_config(spec), PlannerCatalog::built_in());
  const RangeFinder finder(spec.flight.range_finder);
  Random random(1);
  Scan scan;
  for (const Vec2& corner :
       {Vec2(1, 1), Vec2(0, 1), Vec2(-1, 1), Vec2(-1, 0), Vec2(-1, -1), Vec2(0, -1), Vec2(1, -1)}) {
    finder.sense(*spec.scenario.world, {Vec2(0, 0), corner.normalized()}, 0, random, scan);
    navigator.map(scan);
    navigator.map(scan);  // for cells and for parts of them, by turns
  }
  const VehicleState state = make_model(spec.vehicle.model)->at_rest({0, 0, 0}, Vec2(1, 0));
  bool leaves = false;
  for (int i = 0; i < 10; ++i) {
    finder.sense(*spec.scenario.world, {Vec2(0, 0), Vec2(1, 0)}, 0, random, scan);
    const Setpoint setpoint = navigator.update(scan, state, 0.05 * i);
    const auto& arc = std::get<ArcCommand>(setpoint.motion);
    EXPECT_GE(arc.w_rad_s, 0) << i;
    EXPECT_GT(setpoint.heading_world.y(), -0.5) << i;
    leaves = leaves || arc.w_rad_s > 0.1;
  }
  EXPECT_TRUE(leaves);
}

}  // namespace
}  // namespace voronaut
