#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/benchmarks/known/known_problem.h"
#include "voronaut/benchmarks/known/known_trial.h"
#include "voronaut/benchmarks/runner/child_process.h"
#include "voronaut/environments/random.h"
#include "voronaut/environments/world.h"

// RRTConnect on OMPL's circle queries through a suite of kind `known` and through
// ompl::tools::Benchmark, with the same checker: voronaut-known-against-ompl FOLDER, the folder of
// circle_obstacles.txt and circle_queries.txt. Both are run in turns, a query at a time, so that
// whatever else the machine does falls on both.
namespace voronaut {
namespace {

constexpr double kClearance_m = 0.01;
constexpr int kRuns = 20;  // of each query
constexpr ProcessLimits kLimits;

struct Circles {
  std::shared_ptr<const World> world;
  std::vector<std::pair<Vec2, Vec2>> queries;
};

Circles read(const std::string& folder) {
  std::ifstream file(folder + "/circle_obstacles.txt");
  std::string heading;
  std::getline(file, heading);
  std::getline(file, heading);
  Shapes shapes;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::max());
  Vec2 high = -low;
  double id = 0, x = 0, y = 0, r = 0;
  while (file >> id >> x >> y >> r) {
    shapes.circles.push_back({{x, y}, r});
    low = low.cwiseMin(Vec2(x - r, y - r));
    high = high.cwiseMax(Vec2(x + r, y + r));
  }
  Circles read{std::make_shared<const World>(Bounds{low, high}, shapes), {}};
  std::ifstream queries(folder + "/circle_queries.txt");
  std::string word;
  Vec2 start, goal;
  while (queries >> id >> word >> start.x() >> start.y() >> id >> word >> goal.x() >> goal.y())
    read.queries.emplace_back(start, goal);
  return read;
}

// Of the runs of one query: medians, as other work on the machine stretches single runs.
struct Sums {
  double time_us = 0;
  int solved = 0;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Sums through_us(const TrialSpec& query) {
  const PlannerCatalog planners = PlannerCatalog::built_in();
  Sums sums;
  std::vector<double> times_us;
  for (int run = 0; run < kRuns; ++run) {
    TrialSpec spec = query;
    spec.planner_seed = derive_seed(1, {query.scenario.name}, run);
    const ChildReport child = run_in_child(
        [&] {
          const RunRecord row = run_known_trial(spec, planners, false).record;
          return std::to_string(row.planning_time_us_mean) + " " +
                 (row.outcome == Outcome::goal_reached ? "1" : "0");
        },
        kLimits);
    std::istringstream text(child.output);
    double time_us = 0;
    int solved = 0;
    text >> time_us >> solved;
    times_us.push_back(time_us);
    sums.solved += solved;
  }
  sums.time_us = median(times_us);
  return sums;
}

Sums through_ompl(const TrialSpec& query) {
  const ChildReport child = run_in_child(
      [&] {
        ompl::RNG::setSeed(derive_seed(2, {query.scenario.name}, 0) % 0x7fffffff + 1);
        const KnownProblem problem(query.scenario, query.vehicle.clearance_min_m);
        ompl::geometric::SimpleSetup setup(problem.space_information());
        setup.addStartState(ompl::base::ScopedState<>(problem.space_information()->getStateSpace(),
                                                      problem.definition()->getStartState(0)));
        setup.setGoal(problem.definition()->getGoal());
        ompl::tools::Benchmark benchmark(setup, query.scenario.name);
        benchmark.addPlanner(
            PlannerCatalog::built_in().find("RRTConnect")->make(problem.space_information()));
        benchmark.benchmark({10, 1024, kRuns, 0.05, false, false, false});
        std::vector<double> times_us;
        int solved = 0;
        for (const auto& run : benchmark.getRecordedExperimentData().planners.front().runs) {
          times_us.push_back(1e6 * std::stod(run.at("time REAL")));
          solved += run.at("solved BOOLEAN") == "1" ? 1 : 0;
        }
        return std::to_string(median(times_us)) + " " + std::to_string(solved);
      },
      kLimits);
  Sums sums;
  std::istringstream(child.output) >> sums.time_us >> sums.solved;
  return sums;
}

int compare(const std::string& folder) {
  const Circles circles = read(folder);
  if (circles.queries.empty()) {
    std::cerr << folder << ": no circle_queries.txt here\n";
    return 2;
  }
  Sums ours, theirs;
  for (std::size_t i = 0; i < circles.queries.size(); ++i) {
    TrialSpec spec;
    spec.scenario.name = "query-" + std::to_string(i);
    spec.scenario.world = circles.world;
    spec.scenario.start_world = circles.queries[i].first;
    spec.scenario.goal_world = circles.queries[i].second;
    spec.scenario.goal_tolerance_m = 1e-3;
    spec.vehicle.clearance_min_m = kClearance_m;
    spec.planner = {"RRTConnect", "RRTConnect", {}};
    const Sums us = through_us(spec), ompl = through_ompl(spec);
    ours.time_us += us.time_us, ours.solved += us.solved;
    theirs.time_us += ompl.time_us, theirs.solved += ompl.solved;
  }
  const auto queries = static_cast<double>(circles.queries.size());
  const double n = kRuns * queries;
  std::printf("%-24s %10s %10s\n", "RRTConnect", "median us", "solved");
  std::printf("%-24s %10.1f %7d of %.0f\n", "voronaut, kind: known", ours.time_us / queries,
              ours.solved, n);
  std::printf("%-24s %10.1f %7d of %.0f\n", "ompl::tools::Benchmark", theirs.time_us / queries,
              theirs.solved, n);
  std::printf("ratio %.3f\n", ours.time_us / theirs.time_us);
  return 0;
}

}  // namespace
}  // namespace voronaut

int main(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  if (argc != 2) {
    std::cerr << "usage: voronaut-known-against-ompl FOLDER\n";
    return 2;
  }
  return voronaut::compare(argv[1]);
}
