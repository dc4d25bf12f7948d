#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <ompl/base/Planner.h>

// What a solve may spend, and what ended it.
namespace voronaut {

struct PlanningBudget {
  // One of them counts. State checks are the common currency: equal work for all planners, and it
  // repeats bit for bit. An iteration is one evaluation of the termination condition, as in OMPL's
  // IterationTerminationCondition: it repeats too, but is worth something else in each planner. A
  // wall clock promises statistics only.
  enum class Counts { state_checks, iterations, wall_clock };
  // Anytime planners: be content with the first solution, or improve it until the budget is spent.
  enum class Stop { first, budget };

  Counts counts = Counts::state_checks;
  std::uint64_t state_checks = 50'000;      // states and motions put to the checker
  std::uint64_t ptc_evaluations = 200'000;  // cap for planners that stop checking but not searching
  std::uint64_t iterations = 10'000;
  double wall_clock_s = 0.1;
  Stop stop = Stop::budget;
};

enum class SolveEnd {
  planner,         // it returned by itself
  first_solution,  // an anytime planner, told to stop there
  state_checks,
  ptc_evaluations,
  iterations,
  wall_clock,
};
inline constexpr std::size_t kSolveEnds = 6;
std::string_view to_string(SolveEnd end);

// Counts what one solve spends. Copies share the count. May be asked from several threads.
class BudgetMeter {
 public:
  // state_checks: how many checks were ever made; called at each evaluation.
  BudgetMeter(const PlanningBudget& budget, std::function<std::uint64_t()> state_checks);

  // True from the moment the budget is spent; outlives the meter.
  ompl::base::PlannerTerminationCondition condition() const;
  // Which limit was met; empty as long as none was.
  std::optional<SolveEnd> ran_out() const;
  PlanningBudget::Stop stop() const;
  std::uint64_t state_checks_spent() const;
  double seconds_spent() const;

 private:
  struct Spending;
  std::shared_ptr<Spending> spending_;
};

struct SolveReport {
  ompl::base::PlannerStatus status;
  SolveEnd end = SolveEnd::planner;
};

// A better solution of an anytime planner, and what it had cost by then.
struct Improvement {
  std::uint64_t state_checks = 0;
  double time_s = 0;  // wall clock
  double cost = 0;    // of the objective: metres
};

// Sets a planner up for its problem definition, as solve_within() does if that is not done yet.
// Stop::first gives anytime planners an objective that every path satisfies; they read it here.
void set_up(ompl::base::Planner& planner, PlanningBudget::Stop stop);

// Solves within the meter's budget. Stop::first sets up as above, and ends those that do not care
// for it (LBTRRT, LazyLBTRRT) as soon as their progress property "best cost" is finite.
//
// `improvements`, if given, gets each better cost that the planner tells by that property, seen
// once per evaluation of the termination condition; nothing of planners without it or with threads.
SolveReport solve_within(ompl::base::Planner& planner, const BudgetMeter& meter,
                         std::vector<Improvement>* improvements = nullptr);

}  // namespace voronaut
