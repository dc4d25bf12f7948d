#pragma once

#include <cstdint>
#include <functional>
#include <limits>
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
  std::uint64_t state_checks = 50'000;
  std::uint64_t ptc_evaluations = 200'000;
  std::uint64_t iterations = 10'000;
  double wall_clock_s = 0.1;
  Stop stop = Stop::budget;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
    v.alternatives(counts, {{Counts::state_checks, {"state_checks", "ptc_evaluations"}},
                            {Counts::iterations, {"iterations"}},
                            {Counts::wall_clock, {"wall_clock_s"}}});
    const auto named = [&](Counts group) { return v.all_groups() || counts == group; };
    if (named(Counts::state_checks)) {
      v.count("state_checks", state_checks, 1, kLargest,
              "States and motions that a solve may put to the checker");
      v.count("ptc_evaluations", ptc_evaluations, 1, kLargest,
              "Cap for planners that stop checking but not searching");
    }
    if (named(Counts::iterations))
      v.count("iterations", iterations, 1, kLargest,
              "Evaluations of the termination condition instead of state checks");
    if (named(Counts::wall_clock))
      v.number("wall_clock_s", wall_clock_s, 1e-6, 1e6,
               "Wall clock instead of state checks: results do not repeat");
    v.choice("stop", stop, {{"first", Stop::first}, {"budget", Stop::budget}},
             "Anytime planners: at the first solution, or when the budget is spent");
  }
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
