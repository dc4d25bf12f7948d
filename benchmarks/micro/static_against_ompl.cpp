#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/tools/benchmark/Benchmark.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/static_planning/static_problem.h"
#include "voronaut/benchmarks/static_planning/static_trial.h"
#include "voronaut/benchmarks/trial/ompl_seed.h"
#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/formats/ompl_worlds.h"
#include "voronaut/environments/random.h"
#include "voronaut/environments/world.h"
#include "voronaut/reports/summary/estimate.h"

// RRTConnect on OMPL's circle queries through a suite of kind `static` and through
// ompl::tools::Benchmark, with the same checker and the same seeds:
//
//   voronaut-static-against-ompl FOLDER [RUNS [MOTION_US]]
//
// FOLDER is that of circle_obstacles.txt and circle_queries.txt, RUNS the seeds of each query, and
// the checker takes MOTION_US longer for each motion, both ways, as a costly one would. Both are
// run in turns, a query at a time, so that whatever else the machine does falls on both. Exit code
// 1 unless each run did the same work both ways.
//
// Benchmark's own property `time` is more than solve(): OMPL 1.5.2's RunPlanner::runThread stops
// its clock when solve(ptc, 0.1) has returned, whose termination condition polls in a thread of its
// own, which its destructor joins: the thread sleeps 1 ms at a time and has to be scheduled to
// notice. So there is a clock within the planner too.
namespace voronaut {
namespace {

namespace ob = ompl::base;

constexpr double kClearance_m = 0.01;
constexpr ProcessLimits kLimits;

struct Circles {
  std::shared_ptr<const World> world;
  std::vector<ForeignQuery> queries;
};

Circles read(const std::string& folder) {
  const std::string obstacles = folder + "/circle_obstacles.txt";
  const std::string queries = folder + "/circle_queries.txt";
  const ForeignWorld circles = parse_ompl_circles(read_text_file(obstacles), obstacles);
  return {std::make_shared<const World>(*circles.bounds, circles.shapes),
          parse_ompl_circle_queries(read_text_file(queries), queries)};
}

struct Run {
  double solve_us = 0;      // wall time within solve()
  double benchmark_us = 0;  // what ompl::tools::Benchmark writes as `time`
  std::uint64_t checks = 0;
  bool solved = false;
};

std::string to_text(const Run& run) {
  std::ostringstream text;
  text << run.solve_us << ' ' << run.benchmark_us << ' ' << run.checks << ' ' << run.solved << '\n';
  return text.str();
}

std::vector<Run> runs_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<Run> runs;
  Run run;
  while (in >> run.solve_us >> run.benchmark_us >> run.checks >> run.solved) runs.push_back(run);
  return runs;
}

std::uint64_t seed_of(const TrialSpec& query, int run) {
  return derive_seed(1, {query.scenario.name}, run);
}

// The problem's own motion validator, and then some time.
class CostlyMotions : public ob::MotionValidator {
 public:
  CostlyMotions(const ob::SpaceInformationPtr& si, double motion_us)
      : MotionValidator(si), exact_(si->getMotionValidator()), spent_(motion_us) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    wait();
    return exact_->checkMotion(from, to);
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last_valid) const override {
    wait();
    return exact_->checkMotion(from, to, last_valid);
  }

 private:
  void wait() const {
    const auto end = std::chrono::steady_clock::now() + spent_;
    while (std::chrono::steady_clock::now() < end) continue;
  }

  ob::MotionValidatorPtr exact_;
  std::chrono::duration<double, std::micro> spent_;
};

void make_costly(const ob::SpaceInformationPtr& si, double motion_us) {
  if (motion_us > 0) si->setMotionValidator(std::make_shared<CostlyMotions>(si, motion_us));
}

std::vector<Run> through_us(const TrialSpec& query, int runs, double motion_us) {
  PlannerCatalog planners;
  planners.add({"RRTConnect", "OMPL's", {}, [motion_us](const ob::SpaceInformationPtr& si) {
                  make_costly(si, motion_us);
                  return std::make_shared<ompl::geometric::RRTConnect>(si);
                }});
  std::string text;
  for (int run = 0; run < runs; ++run) {
    TrialSpec spec = query;
    spec.planner_seed = seed_of(query, run);
    text += run_in_child(
                [&] {
                  const RunRecord row = run_static_trial(spec, planners, false).record;
                  return to_text({row.planning_time_us_mean, 0,
                                  static_cast<std::uint64_t>(row.state_checks),
                                  row.outcome == Outcome::goal_reached});
                },
                kLimits)
                .output;
  }
  return runs_of(text);
}

// Keeps a clock around the search itself, and tells Benchmark of it as a property of the run.
class ClockedRRTConnect : public ompl::geometric::RRTConnect {
 public:
  ClockedRRTConnect(const ob::SpaceInformationPtr& si, const StaticProblem& problem)
      : RRTConnect(si), problem_(problem) {}

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& condition) override {
    const std::uint64_t checks_before = problem_.state_checks();
    const auto start = std::chrono::steady_clock::now();
    const ob::PlannerStatus status = RRTConnect::solve(condition);
    spent_ = std::chrono::steady_clock::now() - start;
    checks_ = problem_.state_checks() - checks_before;
    return status;
  }

  void getPlannerData(ob::PlannerData& data) const override {
    RRTConnect::getPlannerData(data);
    data.properties["solve time REAL"] = std::to_string(spent_.count());
    data.properties["state checks INTEGER"] = std::to_string(checks_);
  }

 private:
  const StaticProblem& problem_;
  std::chrono::duration<double, std::micro> spent_{};
  std::uint64_t checks_ = 0;
};

// What draws a seed in a trial before RRTConnect's sampler does: the planner, and the choice of
// pivots in the nearest-neighbour structure of each of its two trees. Benchmark makes them once.
void seed_as_a_trial(std::uint64_t planner_seed) {
  seed_ompl(planner_seed);
  const std::array<ompl::RNG, 3> before_the_sampler;
}

std::vector<Run> through_ompl(const TrialSpec& query, int runs, double motion_us) {
  const ChildReport child = run_in_child(
      [&] {
        const StaticProblem problem(query.scenario, query.vehicle.planning_clearance_m);
        make_costly(problem.space_information(), motion_us);
        ompl::geometric::SimpleSetup setup(problem.space_information());
        setup.addStartState(ob::ScopedState<>(problem.space_information()->getStateSpace(),
                                              problem.definition()->getStartState(0)));
        setup.setGoal(problem.definition()->getGoal());
        ompl::tools::Benchmark benchmark(setup, query.scenario.name);
        const auto planner =
            std::make_shared<ClockedRRTConnect>(problem.space_information(), problem);
        benchmark.addPlanner(planner);
        int run = 0;
        benchmark.setPreRunEvent(
            [&](const ob::PlannerPtr&) { seed_as_a_trial(seed_of(query, run++)); });
        benchmark.benchmark({10, 1024, static_cast<unsigned>(runs), 0.05, false, false, false});
        std::string text;
        for (const auto& row : benchmark.getRecordedExperimentData().planners.front().runs)
          text += to_text(
              {std::stod(row.at("solve time REAL")), 1e6 * std::stod(row.at("time REAL")),
               std::stoull(row.at("state checks INTEGER")), row.at("solved BOOLEAN") == "1"});
        return text;
      },
      kLimits);
  return runs_of(child.output);
}

TrialSpec query_of(const Circles& circles, std::size_t index) {
  TrialSpec spec;
  spec.scenario.name = "query-" + std::to_string(index);
  spec.scenario.world = circles.world;
  spec.scenario.start_world = circles.queries[index].start;
  spec.scenario.goal_world = circles.queries[index].goal;
  spec.scenario.goal_tolerance_m = 1e-3;
  spec.vehicle.planning_clearance_m = kClearance_m;
  spec.planner = {"RRTConnect", "RRTConnect", {}};
  return spec;
}

// Not the mean: other work on the machine stretches single runs.
double median_us(const std::vector<Run>& runs, double Run::*time_us) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const Run& run : runs) values.push_back(run.*time_us);
  return quantile(values, 0.5);
}

// Sums over the queries; of the runs of one query the medians.
struct Comparison {
  double ours_us = 0, solve_us = 0, benchmark_us = 0;
  std::vector<double> ratios;  // of each query
  int runs = 0;
  int same_work = 0;  // solved both ways with the same number of state checks

  void add(const std::vector<Run>& us, const std::vector<Run>& ompl) {
    const double us_us = median_us(us, &Run::solve_us), ompl_us = median_us(ompl, &Run::solve_us);
    ours_us += us_us;
    solve_us += ompl_us;
    benchmark_us += median_us(ompl, &Run::benchmark_us);
    ratios.push_back(us_us / ompl_us);
    for (std::size_t i = 0; i < std::min(us.size(), ompl.size()); ++i)
      same_work += us[i].solved && ompl[i].solved && us[i].checks == ompl[i].checks ? 1 : 0;
  }

  void print() const {
    const auto n = static_cast<double>(ratios.size());
    std::printf("RRTConnect: mean of the medians of %zu queries, us\n", ratios.size());
    std::printf("  %-44s %10.1f\n", "voronaut, kind: static", ours_us / n);
    std::printf("  %-44s %10.1f\n", "ompl::tools::Benchmark, within solve()", solve_us / n);
    std::printf("  %-44s %10.1f\n", "ompl::tools::Benchmark, its property time", benchmark_us / n);
    std::printf("ratio within solve() %.3f, of single queries %.3f .. %.3f (quartiles)\n",
                ours_us / solve_us, quantile(ratios, 0.25), quantile(ratios, 0.75));
    std::printf("ratio to its property time %.3f\n", ours_us / benchmark_us);
    std::printf("the same work both ways, and solved: %d of %d runs\n", same_work, runs);
  }
};

int compare(const std::string& folder, int runs, double motion_us) {
  const Circles circles = read(folder);
  Comparison comparison;
  for (std::size_t i = 0; i < circles.queries.size(); ++i) {
    const TrialSpec spec = query_of(circles, i);
    comparison.add(through_us(spec, runs, motion_us), through_ompl(spec, runs, motion_us));
    comparison.runs += runs;
  }
  comparison.print();
  return comparison.same_work == comparison.runs ? 0 : 1;
}

}  // namespace
}  // namespace voronaut

int main(int argc, char** argv) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const int runs = argc > 2 ? std::atoi(argv[2]) : 20;
  const double motion_us = argc > 3 ? std::atof(argv[3]) : 0;
  if (argc < 2 || argc > 4 || runs < 1 || motion_us < 0) {
    std::cerr << "usage: voronaut-static-against-ompl FOLDER [RUNS [MOTION_US]]\n";
    return 2;
  }
  try {
    return voronaut::compare(argv[1], runs, motion_us);
  } catch (const voronaut::ConfigError& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
