#include "voronaut/planners/problem/planning_budget.h"

#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

namespace voronaut {

namespace ob = ompl::base;

std::string_view to_string(SolveEnd end) {
  switch (end) {
    case SolveEnd::planner:
      break;
    case SolveEnd::first_solution:
      return "first_solution";
    case SolveEnd::state_checks:
      return "state_checks";
    case SolveEnd::ptc_evaluations:
      return "ptc_evaluations";
    case SolveEnd::iterations:
      return "iterations";
    case SolveEnd::wall_clock:
      return "wall_clock";
  }
  return "planner";
}

struct BudgetMeter::Spending {
  using Clock = std::chrono::steady_clock;

  PlanningBudget budget;
  std::function<std::uint64_t()> state_checks;
  std::uint64_t checks_at_start = 0;
  Clock::time_point start = Clock::now();
  std::atomic<std::uint64_t> evaluations = 0;
  std::atomic<SolveEnd> end = SolveEnd::planner;

  bool is_spent() {
    const std::uint64_t evaluated = ++evaluations;
    if (end != SolveEnd::planner) return true;
    if (const auto met = limit_met(evaluated)) end = *met;
    return end != SolveEnd::planner;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }

  std::optional<SolveEnd> limit_met(std::uint64_t evaluated) const {
    switch (budget.counts) {
      case PlanningBudget::Counts::state_checks:
        if (state_checks() - checks_at_start >= budget.state_checks) return SolveEnd::state_checks;
        if (evaluated > budget.ptc_evaluations) return SolveEnd::ptc_evaluations;
        break;
      case PlanningBudget::Counts::iterations:
        if (evaluated > budget.iterations) return SolveEnd::iterations;
        break;
      case PlanningBudget::Counts::wall_clock:
        if (seconds() >= budget.wall_clock_s) return SolveEnd::wall_clock;
        break;
    }
    return std::nullopt;
  }
};

BudgetMeter::BudgetMeter(const PlanningBudget& budget, std::function<std::uint64_t()> state_checks)
    : spending_(std::make_shared<Spending>()) {
  spending_->budget = budget;
  spending_->checks_at_start = state_checks();
  spending_->state_checks = std::move(state_checks);
}

ob::PlannerTerminationCondition BudgetMeter::condition() const {
  return ob::PlannerTerminationCondition([spending = spending_] { return spending->is_spent(); });
}

std::optional<SolveEnd> BudgetMeter::ran_out() const {
  const SolveEnd end = spending_->end;
  return end == SolveEnd::planner ? std::nullopt : std::optional(end);
}

PlanningBudget::Stop BudgetMeter::stop() const { return spending_->budget.stop; }

std::uint64_t BudgetMeter::state_checks_spent() const {
  return spending_->state_checks() - spending_->checks_at_start;
}

double BudgetMeter::seconds_spent() const { return spending_->seconds(); }

namespace {

// Any path will do.
void be_content_with_any_path(const ob::ProblemDefinitionPtr& definition) {
  auto length =
      std::make_shared<ob::PathLengthOptimizationObjective>(definition->getSpaceInformation());
  length->setCostThreshold(length->infiniteCost());
  definition->setOptimizationObjective(length);
}

// The planner's own word that it has a path, null if it has no such word.
ob::Planner::PlannerProgressProperty best_cost_of(const ob::Planner& planner) {
  for (const auto& [name, value] : planner.getPlannerProgressProperties())
    if (name.starts_with("best cost ")) return value;
  return nullptr;
}

// Infinite as long as there is none.
double cost_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? value : std::numeric_limits<double>::infinity();
}

void note(const std::string& best_cost, const BudgetMeter& meter,
          std::vector<Improvement>& improvements) {
  const double cost = cost_in(best_cost);
  const bool better = improvements.empty() || cost < improvements.back().cost;
  if (std::isfinite(cost) && better)
    improvements.push_back({meter.state_checks_spent(), meter.seconds_spent(), cost});
}

bool ends_at_first(const ob::Planner& planner, PlanningBudget::Stop stop) {
  return stop == PlanningBudget::Stop::first && planner.getSpecs().optimizingPaths;
}

SolveEnd end_of(ob::PlannerStatus status, bool first, const BudgetMeter& meter) {
  if (const auto spent = meter.ran_out()) return *spent;
  return first && status == ob::PlannerStatus::EXACT_SOLUTION ? SolveEnd::first_solution
                                                              : SolveEnd::planner;
}

}  // namespace

void set_up(ob::Planner& planner, PlanningBudget::Stop stop) {
  if (ends_at_first(planner, stop)) be_content_with_any_path(planner.getProblemDefinition());
  planner.setup();
}

SolveReport solve_within(ob::Planner& planner, const BudgetMeter& meter,
                         std::vector<Improvement>* improvements) {
  const bool first = ends_at_first(planner, meter.stop());
  ob::PlannerTerminationCondition condition = meter.condition();
  // Not every planner does this when it solves: QRRT and AnytimePathShortening of OMPL 1.5.2.
  if (!planner.isSetup()) set_up(planner, meter.stop());
  // A property is read between the steps of the search: not where several threads search.
  const auto best_cost = planner.getSpecs().multithreaded ? nullptr : best_cost_of(planner);
  if (best_cost && (first || improvements != nullptr)) {
    condition = ob::plannerOrTerminationCondition(
        condition, ob::PlannerTerminationCondition([best_cost, first, improvements, &meter] {
          if (improvements != nullptr) note(best_cost(), meter, *improvements);
          return first && std::isfinite(cost_in(best_cost()));
        }));
  }
  const ob::PlannerStatus status = planner.solve(condition);
  if (best_cost && improvements != nullptr) note(best_cost(), meter, *improvements);
  return {status, end_of(status, first, meter)};
}

}  // namespace voronaut
