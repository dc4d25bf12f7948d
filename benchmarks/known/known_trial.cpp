#include "voronaut/benchmarks/known/known_trial.h"

#include <chrono>
#include <memory>

#include <ompl/util/RandomNumbers.h>

#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/known/known_problem.h"
#include "voronaut/benchmarks/known/known_trace.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/planning_budget.h"
#include "voronaut/planners/problem/search_graph.h"
#include "voronaut/planners/problem/solution_path.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

// One solve, everything made anew.
struct KnownSolve {
  KnownSolve(const TrialSpec& spec, const PlannerCatalog& planners, bool watch)
      : problem(spec.scenario, spec.vehicle.clearance_min_m) {
    planner = planners.find(spec.planner.name)->make(problem.space_information());
    set_parameters(*planner, spec.planner.name, spec.planner.params);
    planner->setProblemDefinition(problem.definition());
    set_up(*planner, spec.budget.stop);
    const BudgetMeter meter(spec.budget, [this] { return problem.state_checks(); });
    const auto start = std::chrono::steady_clock::now();
    report = solve_within(*planner, meter, watch ? &improvements : nullptr);
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - start;
    time_us = spent.count();
    checks = problem.state_checks();
  }

  KnownProblem problem;
  ob::PlannerPtr planner;
  SolveReport report;
  std::vector<Improvement> improvements;
  double time_us = 0;
  std::uint64_t checks = 0;
};

void seed(std::uint64_t planner_seed) {
  ompl::RNG::setSeed(static_cast<std::uint_fast32_t>(planner_seed % 0x7fffffffU) + 1);
}

void judge(RunRecord& record, const KnownSolve& solved, const SolutionPath& path,
           const KnownProblem& unseen) {
  const ob::PlannerStatus& status = solved.report.status;
  const auto* insight = dynamic_cast<const PlannerInsight*>(solved.planner.get());
  record.reason = status.asString();
  if (path.to_goal) {
    const bool clear = is_clear(path.p_world, unseen.request(), unseen.truth());
    record.outcome = clear ? Outcome::goal_reached : Outcome::collision;
    if (status == ob::PlannerStatus::APPROXIMATE_SOLUTION)
      record.reason += ", but its path ends at the goal";
  } else if (!path.flaw.empty()) {
    record.outcome = Outcome::timeout;
    record.reason += ", but " + path.flaw;
  } else if (insight != nullptr && insight->proved_no_path()) {
    record.outcome = Outcome::infeasible;
  } else if (status == ob::PlannerStatus::INVALID_START ||
             status == ob::PlannerStatus::INVALID_GOAL) {
    record.outcome = Outcome::invalid;
  } else {
    record.outcome = Outcome::timeout;
  }
}

// The path as if a vehicle had stood at each vertex.
std::vector<Tick> vertices(const std::vector<Vec2>& path_world, const World& world) {
  std::vector<Tick> ticks;
  for (const Vec2& p : path_world) {
    Tick& tick = ticks.emplace_back();
    tick.state.p_world = {p.x(), p.y(), 0};
    tick.state.v_world.setZero();
    tick.state.w_body.setZero();
    tick.clearance_m = world.clearance_m(p);
  }
  return ticks;
}

void add_path(RunRecord& record, const std::vector<Vec2>& path_world, const Scenario& scenario) {
  const std::vector<Tick> path = vertices(path_world, *scenario.world);
  const bool success = record.outcome == Outcome::goal_reached;
  record.spl = 0;
  if (path.empty()) return;
  record.path_length_m = path_length_m(path);
  record.clearance_min_m = clearance_min_m(path);
  record.clearance_mean_m = clearance_mean_m(path);
  record.end_x_m = path.back().state.p_world.x();
  record.end_y_m = path.back().state.p_world.y();
  record.spl =
      spl(success, record.shortest_length_m, record.path_length_m, scenario.goal_tolerance_m);
  if (success) {
    // As in flight: a path may end at the goal's tolerance, the rest of the way counts.
    const double left_m = (path_world.back() - scenario.goal_world).norm();
    record.path_ratio = path_ratio(record.path_length_m + left_m, record.shortest_length_m,
                                   scenario.goal_tolerance_m);
  }
  record.state_digest = state_digest(path);
}

bool starts_at_goal(const KnownProblem& problem) {
  const std::vector<Vec2> path{problem.request().start_world};
  return flaw_of(path, problem.request()).empty() &&
         is_clear(path, problem.request(), problem.truth());
}

// Of who is there already: many planners would go round in a circle.
TrialResult nothing_to_plan(const TrialSpec& spec, bool keep_trace) {
  const std::vector<Vec2> path{spec.scenario.start_world};
  TrialResult result{record_before_flight(spec), std::nullopt};
  result.record.outcome = Outcome::goal_reached;
  result.record.reason = "starts at the goal";
  add_path(result.record, path, spec.scenario);
  if (keep_trace) result.trace = known_trace(spec, Path{}, {}, {});
  return result;
}

RunRecord record_of(const TrialSpec& spec, const KnownSolve& solved, const SolutionPath& found,
                    const KnownProblem& unseen) {
  RunRecord record = record_before_flight(spec);
  judge(record, solved, found, unseen);
  record.replans = 1;
  record.state_checks = static_cast<std::int64_t>(solved.checks);
  std::array<std::int64_t, kSolveEnds> ends{};
  ends[static_cast<std::size_t>(solved.report.end)] = 1;
  add_solve_ends(record, ends);
  record.planning_time_us_mean = solved.time_us;
  add_path(record, found.p_world, spec.scenario);
  return record;
}

}  // namespace

TrialResult run_known_trial(const TrialSpec& spec, const PlannerCatalog& planners,
                            bool keep_trace) {
  const KnownProblem unseen(spec.scenario, spec.vehicle.clearance_min_m);
  if (starts_at_goal(unseen)) return nothing_to_plan(spec, keep_trace);
  {
    // Untimed: the first solve of a process pays for pages and caches. Of another seed: the
    // processor predicts the branches of a search that it has just done.
    seed(spec.planner_seed + 1);
    const KnownSolve warm_up(spec, planners, keep_trace);
  }
  seed(spec.planner_seed);
  KnownSolve solved(spec, planners, keep_trace);

  const SolutionPath found =
      solution_path(solved.report.status, *solved.problem.definition(),
                    *unseen.space_information()->getStateSpace(), unseen.request(), unseen.truth());
  TrialResult result{record_of(spec, solved, found, unseen), std::nullopt};
  if (!keep_trace) return result;
  result.trace = known_trace(
      spec, Path::through(found.p_world), solved.improvements,
      search_graph(*solved.planner, *solved.problem.space_information()->getStateSpace()));
  return result;
}

}  // namespace voronaut
