#include "voronaut/benchmarks/micro/governed_cycle.h"

#include <cmath>

#include <ompl/util/Console.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/episode/flown_trial.h"
#include "voronaut/benchmarks/episode/ground_truth_collision_checker.h"
#include "voronaut/environments/scenario/scenario_spec.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/navigation/governor_setup.h"

namespace voronaut::micro {
namespace {

TrialSpec governed_trial(const std::string& vehicle, const std::string& forest,
                         std::uint64_t seed = 1) {
  TrialSpec spec;
  spec.scenario =
      ScenarioSpec::generated({}, WorldGenerator::read(ConfigNode::parse(forest, "governed cycle")))
          .instantiate(seed);
  spec.vehicle = find_vehicle(vehicle);
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

// A flight, step by step, stopped where a scan has come in.
class GovernedFlight {
 public:
  explicit GovernedFlight(const TrialSpec& spec) : spec_(spec) {
    flight_.navigator.observe(nullptr);
    flight_.regulator->reset(state_);
  }

  // Flies on to the next scan, up to where navigation is asked for a setpoint; false at the end.
  bool to_next_scan() {
    for (bool scanned = false; !scanned; navigated_ = true) {
      if (navigated_) finish_step();
      if (flight_.referee.verdict()) return false;
      scanned = flight_.scan_is_due(tick_);
      if (!scanned) {
        steer();
        continue;
      }
      flight_.navigator.map(flight_.sense(state_, state_, now_s()));
      flight_.navigator.plan(state_, now_s());
    }
    return true;
  }
  bool departed() const { return flight_.navigator.report().departed_s.has_value(); }
  const Scan& scan() const { return flight_.scan; }
  void steer() { setpoint_ = flight_.navigator.steer(state_, now_s()); }

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

  TrialSpec spec_;
  PlannerCatalog planners_ = PlannerCatalog::built_in();
  Flight flight_{spec_, planners_, false};
  VehicleState state_ = flight_.at_start();
  Command applied_ = flight_.model->hold();
  Setpoint setpoint_;
  std::size_t tick_ = 0;
  bool navigated_ = false;  // at this tick, or about to
};

constexpr const char* kSmallForest = "{name: forest, side_m: 10, density_per_m2: 0.1}";
constexpr const char* kForest = "{name: forest, side_m: 20, density_per_m2: 0.15}";

class GovernedCycle : public CountedWork {
 public:
  bool prepare() override {
    while (flight_.to_next_scan()) {
      if (flight_.departed()) return true;
      free_space_.update(flight_.scan());
      flight_.steer();
    }
    return false;
  }
  std::size_t run() override {
    free_space_.update(flight_.scan());
    flight_.steer();
    return 1;
  }

 private:
  TrialSpec spec_ = governed_trial("quadrotor", kSmallForest);
  GovernedFlight flight_{spec_};
  // The navigator keeps its own to itself; what bringing it up to date costs is counted on a second
  // one, which sees the same scans.
  FreeSpace free_space_ = free_space_of(navigator_config(spec_));
};

class KnownFree : public CountedWork {
 public:
  bool prepare() override {
    if (scans_ > 0) flight_.steer();
    return flight_.to_next_scan() && ++scans_ > 0;
  }
  std::size_t run() override {
    free_space_.update(flight_.scan());
    return 1;
  }

 private:
  TrialSpec spec_ = governed_trial("ideal", kForest);
  GovernedFlight flight_{spec_};
  FreeSpace free_space_ = free_space_of(navigator_config(spec_));
  std::size_t scans_ = 0;
};

class GovernedTrial : public CountedWork {
 public:
  explicit GovernedTrial(double rim_m) : rim_(Vec2::Constant(rim_m)) {}
  bool prepare() override {
    if (seed_ == kTrials) return false;
    spec_ = governed_trial("ideal", kForest, ++seed_);
    const World& world = *spec_.scenario.world;
    spec_.scenario.world = std::make_shared<const World>(
        Bounds{world.bounds().min - rim_, world.bounds().max + rim_}, world.shapes());
    spec_.contacts = CollisionScene::of(spec_.scenario.world->shapes());
    return true;
  }
  std::size_t run() override {
    const RunRecord record = run_flown_trial(spec_, planners_, false).record;
    const double flown_s = record.duration_s + spec_.flight.loop.goal_hold_s;
    return static_cast<std::size_t>(std::lround(flown_s / spec_.flight.loop.vehicle_period_s));
  }

 private:
  static constexpr std::uint64_t kTrials = 10;
  PlannerCatalog planners_ = PlannerCatalog::built_in();
  TrialSpec spec_;
  std::uint64_t seed_ = 0;
  Vec2 rim_;
};

}  // namespace

std::unique_ptr<CountedWork> make_governed_cycle() {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  return std::make_unique<GovernedCycle>();
}

std::unique_ptr<CountedWork> make_known_free() {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  return std::make_unique<KnownFree>();
}

std::unique_ptr<CountedWork> make_governed_trial(double rim_m) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  return std::make_unique<GovernedTrial>(rim_m);
}

}  // namespace voronaut::micro
