#include <benchmark/benchmark.h>
#include <ompl/util/Console.h>

#include "voronaut/benchmarks/episode/episode.h"
#include "voronaut/environments/world.h"

// The whole closed loop with a scan, a map update and a plan in every vehicle step: what a second
// of flight costs. The referee's and the log's share is in it.
namespace voronaut::micro {
namespace {

constexpr double kPeriod_s = 0.01;

// Evenly placed obstacles on the way from (0, 0) to (10, 10), as in the scene paper-even.
Scenario even_obstacles() {
  std::vector<Circle> circles;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const Vec2 center(2.5 + 2.7 * i, 1.5 + 2.7 * j);
      if ((center - Vec2(10, 10)).norm() > 1.2) circles.push_back({center, 0.5});
    }
  }
  Scenario scenario;
  scenario.name = "even";
  scenario.world =
      std::make_shared<World>(Bounds{Vec2(-5, -5), Vec2(15, 15)}, Shapes{circles, {}, {}});
  scenario.goal_world = Vec2(10, 10);
  scenario.start_heading = Vec2(1, 1).normalized();
  return scenario;
}

void closed_loop(benchmark::State& state) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const PlannerCatalog planners = PlannerCatalog::built_in();
  TrialSpec spec;
  spec.scenario = even_obstacles();
  spec.vehicle = find_vehicle("quadrotor");
  spec.regulator_name = spec.vehicle.regulator;
  spec.regulator = find_regulator(spec.regulator_name);
  spec.planner = {"repaired", "ReactiveVoronoi", {{"preset", "repaired"}}};
  spec.flight.navigation = NavigationConfig::paper();
  spec.flight.range_finder.rate_hz = 100;
  spec.flight.range_finder.rays = static_cast<int>(state.range(0));
  spec.shortest_length_m = 14.2;

  double steps = 0;
  for (auto _ : state) {
    Flight flight(spec, planners, false);
    const EpisodeLog log = fly(flight);
    steps += static_cast<double>(log.ticks.size());
    if (log.verdict.outcome != Outcome::goal_reached) state.SkipWithError("did not arrive");
  }
  using benchmark::Counter;
  state.counters["steps_per_flight"] = Counter(steps, Counter::kAvgIterations);
  state.counters["time_per_step"] = Counter(steps, Counter::kIsRate | Counter::kInvert);
  state.counters["real_time_factor"] =
      Counter(steps * spec.flight.loop.vehicle_period_s, Counter::kIsRate);
}
BENCHMARK(closed_loop)->Arg(91)->Arg(181)->Unit(benchmark::kMillisecond);

// The quadrotor's model and its regulator, turn and turn about, to a target 3 m away and back.
void vehicle_step(benchmark::State& state) {
  const VehicleSpec spec = find_vehicle("quadrotor");
  const std::unique_ptr<Model> model = make_model(spec.model);
  const auto law = make_regulator(find_regulator(spec.regulator), spec, kPeriod_s);
  VehicleState at = model->at_rest(Vec3(0, 0, 1), Vec2(1, 0));
  Command command = model->hold();
  law->reset(at);
  Setpoint setpoint;
  setpoint.height_m = 1;
  const bool regulated = state.range(0) == 1;
  std::size_t steps = 0;
  for (auto _ : state) {
    setpoint.motion = PassTarget{Vec2(++steps / 200 % 2 == 0 ? 3 : 0, 0), 2};
    if (regulated) command = law->regulate(setpoint, at);
    at = model->step(at, command, kPeriod_s);
    benchmark::DoNotOptimize(at);
  }
}
BENCHMARK(vehicle_step)->Name("vehicle/step")->ArgName("regulated")->Arg(0)->Arg(1);

}  // namespace
}  // namespace voronaut::micro
