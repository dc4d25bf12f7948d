#include "voronaut/benchmarks/micro/governed_cycle.h"

#include <ompl/util/Console.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/environments/world.h"

namespace voronaut::micro {
namespace {

TrialSpec governed_trial() {
  TrialSpec spec;
  const std::string forest = "{name: forest, side_m: 10, density_per_m2: 0.1}";
  spec.scenario =
      ScenarioSpec::generated({}, WorldGenerator::read(ConfigNode::parse(forest, "governed cycle")))
          .instantiate(1);
  spec.vehicle = find_vehicle("quadrotor");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"VoronoiRoadmap", "VoronoiRoadmap", {}};
  spec.flight.range_finder.rays = 91;
  spec.flight.navigation.governor = spec.flight.navigation.look_around =
      spec.flight.navigation.recovery = true;
  spec.flight.navigation.yaw_policy = YawReference::path;
  spec.shortest_length_m = 15;
  return spec;
}

// The navigator keeps its known-free space to itself; what bringing it up to date costs is counted
// on a second one, which sees the same scans.
FreeSpace free_space_of(const NavigatorConfig& config) {
  const Vec2 rim(config.vehicle.planning_clearance_m, config.vehicle.planning_clearance_m);
  const Bounds& bounds = config.mission.bounds_world;
  return FreeSpace({bounds.min - rim, bounds.max + rim});
}

class GovernedCycle : public CountedWork {
 public:
  GovernedCycle() {
    flight_.navigator.observe(nullptr);
    flight_.regulator->reset(state_);
  }

  // Flies on to the next scan after departure, up to where navigation is asked.
  bool prepare() override {
    for (;;) {
      if (navigated_) finish_step();
      navigated_ = true;
      if (flight_.referee.verdict()) return false;
      const bool scanned = flight_.scan_is_due(tick_);
      if (scanned) {
        flight_.navigator.map(flight_.sense(state_, now_s()));
        flight_.navigator.plan(state_, now_s());
        free_space_.update(flight_.scan);
      }
      if (scanned && flight_.navigator.report().departed_s) return true;
      setpoint_ = flight_.navigator.steer(state_, now_s());
    }
  }
  // Known-free space has this scan already; taking it again costs the same.
  std::size_t run() override {
    free_space_.update(flight_.scan);
    setpoint_ = flight_.navigator.steer(state_, now_s());
    return 1;
  }

 private:
  double now_s() const { return static_cast<double>(tick_) * spec_.flight.loop.vehicle_period_s; }
  void finish_step() {
    const Command command = flight_.regulator->regulate(setpoint_, state_);
    state_ = flight_.model->step(state_, applied_, spec_.flight.loop.vehicle_period_s);
    applied_ = command;
    flight_.referee.hear(now_s(), flight_.navigator.report());
    ++tick_;
    flight_.referee.judge(now_s(), state_);
  }

  TrialSpec spec_ = governed_trial();
  PlannerCatalog planners_ = PlannerCatalog::built_in();
  Flight flight_{spec_, planners_, false};
  FreeSpace free_space_ = free_space_of(navigator_config(spec_));
  VehicleState state_ = flight_.at_start();
  Command applied_ = flight_.model->hold();
  Setpoint setpoint_;
  std::size_t tick_ = 0;
  bool navigated_ = false;  // at this tick, or about to
};

}  // namespace

std::unique_ptr<CountedWork> make_governed_cycle() {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  return std::make_unique<GovernedCycle>();
}

}  // namespace voronaut::micro
