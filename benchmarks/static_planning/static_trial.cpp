#include "voronaut/benchmarks/static_planning/static_trial.h"

#include <chrono>
#include <memory>

#include "voronaut/benchmarks/episode/metrics.h"
#include "voronaut/benchmarks/static_planning/static_problem.h"
#include "voronaut/benchmarks/static_planning/static_trace.h"
#include "voronaut/benchmarks/trial/ompl_seed.h"
#include "voronaut/environments/world.h"
#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/planning_budget.h"
#include "voronaut/planners/problem/search_graph.h"
#include "voronaut/planners/problem/solution_path.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

// One solve, everything made anew.
struct StaticSolve {
  StaticSolve(const TrialSpec& spec, const PlannerCatalog& planners, bool watch)
      : problem(spec.scenario, spec.vehicle.planning_clearance_m) {
    planner = planners.find(spec.planner.name)->make(problem.space_information());
    set_parameters(*planner, spec.planner.name, spec.planner.params);
    planner->setProblemDefinition(problem.definition());
    set_up(*planner, spec.flight.budget.stop);
    const BudgetMeter meter(spec.flight.budget, [this] { return problem.state_checks(); });
    const auto start = std::chrono::steady_clock::now();
    report = solve_within(*planner, meter, watch ? &improvements : nullptr);
    const std::chrono::duration<double, std::micro> spent =
        std::chrono::steady_clock::now() - start;
    time_us = spent.count();
    checks = problem.state_checks();
  }

  StaticProblem problem;
  ob::PlannerPtr planner;
  SolveReport report;
  std::vector<Improvement> improvements;
  double time_us = 0;
  std::uint64_t checks = 0;
};

void judge(RunRecord& record, const StaticSolve& solved, const SolutionPath& path,
           const StaticProblem& unseen) {
  const ob::PlannerStatus& status = solved.report.status;
  const auto* insight = dynamic_cast<const PlannerInsight*>(solved.planner.get());
  record.reason = status.asString();
  if (path.to_goal) {
    const bool clear = is_clear(path.p_world, unseen.request(), &unseen.truth());
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

// Of no vertices nothing but that there is no success.
void add_vertices(RunRecord& record, const std::vector<Vec2>& path_world,
                  const Scenario& scenario) {
  const std::vector<Tick> path = vertices(path_world, *scenario.world);
  record.spl = 0;
  if (path.empty()) return;
  add_path(record, path, scenario);
  record.state_digest = state_digest(path);
}

bool starts_at_goal(const StaticProblem& problem) {
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
  add_vertices(result.record, path, spec.scenario);
  if (keep_trace) result.trace = static_trace(spec, Path{}, {}, {});
  return result;
}

RunRecord record_of(const TrialSpec& spec, const StaticSolve& solved, const SolutionPath& found,
                    const StaticProblem& unseen) {
  RunRecord record = record_before_flight(spec);
  judge(record, solved, found, unseen);
  record.replans = 1;
  record.state_checks = static_cast<std::int64_t>(solved.checks);
  std::array<std::int64_t, kSolveEnds> ends{};
  ends[static_cast<std::size_t>(solved.report.end)] = 1;
  add_solve_ends(record, ends);
  record.planning_time_us_mean = solved.time_us;
  add_vertices(record, found.p_world, spec.scenario);
  return record;
}

}  // namespace

TrialResult run_static_trial(const TrialSpec& spec, const PlannerCatalog& planners,
                             bool keep_trace) {
  const StaticProblem unseen(spec.scenario, spec.vehicle.planning_clearance_m);
  if (starts_at_goal(unseen)) return nothing_to_plan(spec, keep_trace);
  {
    // Untimed: the first solve of a process pays for pages and caches. Of another seed: the
    // processor predicts the branches of a search that it has just done.
    seed_ompl(spec.planner_seed + 1);
    const StaticSolve warm_up(spec, planners, keep_trace);
  }
  seed_ompl(spec.planner_seed);
  StaticSolve solved(spec, planners, keep_trace);

  const SolutionPath found = solution_path(solved.report.status, *solved.problem.definition(),
                                           *unseen.space_information()->getStateSpace(),
                                           unseen.request(), &unseen.truth());
  TrialResult result{record_of(spec, solved, found, unseen), std::nullopt};
  if (!keep_trace) return result;
  result.trace = static_trace(
      spec, Path::through(found.p_world), solved.improvements,
      search_graph(*solved.planner, *solved.problem.space_information()->getStateSpace()));
  return result;
}

}  // namespace voronaut
