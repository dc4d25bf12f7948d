#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/benchmarks/micro/replan_course.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/navigation/plan_request.h"
#include "voronaut/planners/navigation/shortcut.h"
#include "voronaut/planners/voronoi/voronoi_router.h"
#include "voronaut/reports/summary/estimate.h"

// What a replan costs, planner beside planner: the same questions on the same maps through the same
// exact checker (replan_course.h). Lengths are compared behind the executive's shortcut, which
// every planner's path goes through.
namespace voronaut::micro {
namespace {

// Of this thread's CPU time: a busy machine does not make a replan longer.
double now_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

std::span<const ReplanCourse> courses(const std::string& family, std::int64_t worlds) {
  static std::map<std::string, std::vector<ReplanCourse>> made;
  std::vector<ReplanCourse>& list = made[family];
  for (auto seed = static_cast<std::int64_t>(list.size()); seed < worlds; ++seed)
    list.emplace_back(family, static_cast<std::uint64_t>(seed) + 1);
  return std::span(list).first(static_cast<std::size_t>(worlds));
}

void count_times(benchmark::State& state, std::vector<double> times_us) {
  std::sort(times_us.begin(), times_us.end());
  double sum_us = 0;
  for (const double us : times_us) sum_us += us;
  state.SetIterationTime(sum_us / 1e6);
  state.counters["replans"] = static_cast<double>(times_us.size());
  state.counters["median_us"] = quantile_of_sorted(times_us, 0.5);
  state.counters["p99_us"] = quantile_of_sorted(times_us, 0.99);
  state.counters["max_us"] = times_us.back();
}

// One planner asked in all courses; its lengths are summed where it found a path, and its failures
// counted.
void replan(benchmark::State& state, const std::string& family, const std::string& name,
            std::uint64_t state_checks) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const PlannerCatalog planners = PlannerCatalog::built_in();
  PlanningBudget budget;
  budget.state_checks = state_checks;
  budget.ptc_evaluations = 10'000'000;
  for (auto _ : state) {
    ompl::RNG::setSeed(1);
    std::vector<double> times_us;
    double length_m = 0, voronoi_m = 0, failed = 0;
    for (const ReplanCourse& course : courses(family, state.range(0))) {
      PlanningProblem problem(course.problem());
      PlanningProblem reference(course.problem());
      const PlannerEntry& entry = *planners.find(name);
      const PlannerEntry& voronoi = *planners.find("VoronoiRoadmap");
      const auto planner = entry.make(problem.space_information());
      const auto shortest = voronoi.make(reference.space_information());
      course.fly(planners, [&](const ObstacleSnapshot& obstacles, const Vec2& p) {
        problem.update(obstacles, p);
        const double start_us = now_us();
        const Plan plan = ask_for_plan(*planner, entry.traits, problem, budget);
        times_us.push_back(now_us() - start_us);
        reference.update(obstacles, p);
        const Path other = ask_for_plan(*shortest, voronoi.traits, reference, {}).path;
        if (plan.path.empty() || other.empty()) {
          failed += 1;
          return;
        }
        length_m += shortcut(plan.path, problem.geometry()).length_m();
        voronoi_m += shortcut(other, reference.geometry()).length_m();
      });
    }
    count_times(state, std::move(times_us));
    state.counters["failed"] = failed;
    state.counters["length_ratio"] = length_m / voronoi_m;  // to VoronoiRoadmap's paths
  }
}

// Where VoronoiRoadmap's time goes: working the new points into the diagram (`observe`), making the
// graph of it and searching it (`route`).
void replan_parts(benchmark::State& state, const std::string& family) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const PlannerCatalog planners = PlannerCatalog::built_in();
  for (auto _ : state) {
    std::vector<double> times_us;
    double observe_us = 0, graph_us = 0, route_us = 0, points = 0;
    for (const ReplanCourse& course : courses(family, state.range(0))) {
      VoronoiRouter router;
      const ProblemConfig& config = course.problem();
      course.fly(planners, [&](const ObstacleSnapshot& obstacles, const Vec2& p) {
        const std::vector<Vec2> places = {p, config.goal_world};
        const double start_us = now_us();
        router.observe(obstacles.points(), config.bounds_world, config.planning_clearance_m,
                       places);
        const double observed_us = now_us() - start_us;
        router.graph();
        const double built_us = now_us() - start_us;
        RouteQuery query;
        query.start = p;
        query.goal = config.goal_world;
        benchmark::DoNotOptimize(router.route(query));
        times_us.push_back(now_us() - start_us);
        observe_us += observed_us;
        graph_us += built_us - observed_us;
        route_us += times_us.back() - built_us;
        points += static_cast<double>(obstacles.points().size());
      });
    }
    const double all_us = observe_us + graph_us + route_us;
    state.counters["points"] = points / static_cast<double>(times_us.size());
    state.counters["observe_share"] = observe_us / all_us;
    state.counters["graph_share"] = graph_us / all_us;
    state.counters["route_share"] = route_us / all_us;
    count_times(state, std::move(times_us));
  }
}

// The diagram of random points, 0.1 per square metre, built at once.
void voronoi_build(benchmark::State& state) {
  const auto sites = static_cast<std::size_t>(state.range(0));
  const double half_m = 0.5 * std::sqrt(static_cast<double>(sites) / 0.1);
  Random random(8);
  std::vector<Vec2> points;
  while (points.size() < sites)
    points.emplace_back(random.uniform(-half_m, half_m), random.uniform(-half_m, half_m));
  const Bounds bounds{Vec2::Constant(-half_m), Vec2::Constant(half_m)};
  for (auto _ : state) {
    VoronoiRouter router;
    router.observe(points, bounds, 0.4, {});
    benchmark::DoNotOptimize(&router.graph());
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(voronoi_build)
    ->Name("voronoi/build")
    ->ArgName("sites")
    ->Arg(30)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10'000)
    ->Unit(benchmark::kMicrosecond)
    ->Complexity();

const char* const kForest = "{name: forest, density_per_m2: 0.15}";
const char* const kRooms = "{name: rooms}";

void add(const std::string& where, const std::string& family) {
  const auto once = [&](const std::string& name, std::int64_t worlds, auto&& run) {
    benchmark::RegisterBenchmark(("replan/" + where + "/" + name).c_str(), run)
        ->Arg(worlds)
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  const auto asks = [&](const std::string& name, std::uint64_t state_checks) {
    return [=](benchmark::State& state) { replan(state, family, name, state_checks); };
  };
  once("VoronoiRoadmap", 30, asks("VoronoiRoadmap", 50'000));
  once("VoronoiRoadmap_parts", 30, [=](benchmark::State& state) { replan_parts(state, family); });
  once("RRTConnect", 30, asks("RRTConnect", 50'000));
  for (const std::uint64_t checks : {500, 1000, 2000, 4000, 8000, 16'000})
    once("BITstar_" + std::to_string(checks), 5, asks("BITstar", checks));
}

const bool added = [] {
  add("forest", kForest);
  add("rooms", kRooms);
  return true;
}();

}  // namespace
}  // namespace voronaut::micro
