#include <stdexcept>
#include <vector>

#include <ompl/util/Console.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/benchmarks/micro/counted_work.h"
#include "voronaut/environments/random.h"
#include "voronaut/environments/world.h"

namespace voronaut::micro {
namespace {

constexpr double kPeriod_s = 0.01;

// A quadrotor under way to targets 3 m apart, as its regulator flies it: what is counted repeats
// single steps of it.
struct FlownSteps {
  static constexpr std::size_t kSteps = 5'000;

  FlownSteps() : spec(find_vehicle("quadrotor")), model(make_model(spec.model)) {
    regulator = make_regulator(find_regulator(spec.regulator), spec, kPeriod_s);
    VehicleState state = model->at_rest(Vec3(0, 0, 1), Vec2(1, 0));
    Command applied = model->hold();
    regulator->reset(state);
    Random random(6);
    Setpoint setpoint;
    setpoint.height_m = 1;
    setpoint.motion = PassTarget{Vec2(0, 0), 2};
    for (std::size_t i = 0; i < kSteps; ++i) {
      if (i % 100 == 0)
        setpoint.motion = PassTarget{Vec2(random.uniform(-3, 3), random.uniform(-3, 3)), 2};
      states.push_back(state);
      commands.push_back(applied);
      setpoints.push_back(setpoint);
      const Command command = regulator->regulate(setpoint, state);
      state = model->step(state, applied, kPeriod_s);
      applied = command;
    }
    regulator->reset(states.front());
  }

  VehicleSpec spec;
  std::unique_ptr<Model> model;
  std::unique_ptr<Regulator> regulator;
  std::vector<VehicleState> states;
  std::vector<Command> commands;
  std::vector<Setpoint> setpoints;
};

class VehicleStepWork : public CountedWork {
 public:
  bool prepare() override { return next_ < FlownSteps::kSteps; }
  std::size_t run() override {
    end_ = flown_.model->step(flown_.states[next_], flown_.commands[next_], kPeriod_s);
    ++next_;
    return 1;
  }

 private:
  FlownSteps flown_;
  VehicleState end_;
  std::size_t next_ = 0;
};

class RegulateWork : public CountedWork {
 public:
  bool prepare() override { return next_ < FlownSteps::kSteps; }
  std::size_t run() override {
    command_ = flown_.regulator->regulate(flown_.setpoints[next_], flown_.states[next_]);
    ++next_;
    return 1;
  }

 private:
  FlownSteps flown_;
  Command command_;
  std::size_t next_ = 0;
};

// An alley of posts, one every 2.7 m to each side, irregularly placed, as long as 2 m/s need.
Scenario alley(std::size_t steps) {
  const double length_m = 2.0 * kPeriod_s * static_cast<double>(steps) + 50;
  Random random(7);
  std::vector<Circle> posts;
  for (double x_m = 3; x_m < length_m; x_m += 2.7) {
    for (const double side : {-1.0, 1.0})
      posts.push_back({Vec2(x_m + random.uniform(0, 1), side * random.uniform(1.5, 2.5)), 0.4});
  }
  Scenario scenario;
  scenario.name = "alley";
  scenario.world =
      std::make_shared<World>(Bounds{Vec2(-5, -8), Vec2(length_m + 5, 8)}, Shapes{posts, {}, {}});
  scenario.goal_world = Vec2(length_m, 0);
  return scenario;
}

TrialSpec reactive_trial(std::size_t steps) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  TrialSpec spec;
  spec.scenario = alley(steps);
  spec.vehicle = find_vehicle("quadrotor");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"repaired", "ReactiveVoronoi", {{"preset", "repaired"}}};
  spec.flight.navigation = NavigationConfig::paper();
  spec.flight.range_finder.rate_hz = 1 / kPeriod_s;
  spec.flight.range_finder.rays = 181;
  spec.shortest_length_m = spec.scenario.goal_world.x();
  return spec;
}

class ClosedLoopWork : public CountedWork {
 public:
  ClosedLoopWork(std::size_t skipped, std::size_t steps)
      : last_(skipped + steps),
        spec_(reactive_trial(last_)),
        flight_(spec_, planners_, false),
        state_(flight_.at_start()),
        applied_(flight_.model->hold()) {
    flight_.navigator.observe(nullptr);  // the recorder's share is not counted
    flight_.regulator->reset(state_);
    while (tick_ < skipped) run();
  }
  bool prepare() override {
    // What a standstill would make cheap.
    if (tick_ == last_ && state_.p_world.x() < 0.5 * kPeriod_s * static_cast<double>(last_))
      throw std::logic_error("the vehicle of the closed loop does not get on");
    return tick_ < last_;
  }
  std::size_t run() override {
    const double now_s = kPeriod_s * static_cast<double>(tick_++);
    const Scan& scan = flight_.sense(state_, state_, now_s);
    const Setpoint setpoint = flight_.navigator.update(scan, state_, now_s);
    const Command command = flight_.regulator->regulate(setpoint, state_);
    state_ = flight_.model->step(state_, applied_, kPeriod_s);
    applied_ = command;
    return 1;
  }

 private:
  std::size_t last_;
  PlannerCatalog planners_ = PlannerCatalog::built_in();
  TrialSpec spec_;
  Flight flight_;
  VehicleState state_;
  Command applied_;
  std::size_t tick_ = 0;
};

}  // namespace

CountedWorkPtr vehicle_step_work() { return std::make_unique<VehicleStepWork>(); }
CountedWorkPtr regulate_work() { return std::make_unique<RegulateWork>(); }
CountedWorkPtr closed_loop_work(std::size_t skipped, std::size_t steps) {
  return std::make_unique<ClosedLoopWork>(skipped, steps);
}

}  // namespace voronaut::micro
