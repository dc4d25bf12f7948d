#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/statistic_text.h"

// What a suite says about its planners. Failures stay in every denominator; what can only be said
// about a part of the trials (the path ratio: those that reached the goal) says over how many.
namespace voronaut {

// What is compared under equal conditions: a family of scenarios, flown by one vehicle.
struct SummaryGroup {
  std::string scenario_group;
  std::string vehicle;
  std::string regulator;
  bool all_scenarios = false;  // pooled over the scenario groups; scenario_group is empty then

  friend bool operator==(const SummaryGroup&, const SummaryGroup&) = default;
  friend bool operator<(const SummaryGroup& a, const SummaryGroup& b) {
    return std::tie(a.scenario_group, a.vehicle, a.regulator, a.all_scenarios) <
           std::tie(b.scenario_group, b.vehicle, b.regulator, b.all_scenarios);
  }
};

struct PlannerSummary {
  SummaryGroup group;
  std::string planner;
  std::int64_t n = 0;
  std::int64_t rank = 1;  // 1 + planners of the group that are better (ranks.h)
  OutcomeCounts outcomes{};
  std::vector<Estimate> estimates;  // in the order of statistics()

  // By the name of the statistic; std::invalid_argument for an unknown one.
  const Estimate& of(std::string_view statistic) const;
};

// Two planners on the same (scenario, repetition, vehicle, regulator). Who reached the goal beats
// who did not; of two that reached it the shorter path wins, unless the path ratios are within
// tie_tolerance of each other; two failures tie.
struct PlannerPairing {
  SummaryGroup group;
  std::string planner_a;
  std::string planner_b;
  std::int64_t n = 0;
  std::int64_t wins_a = 0;
  std::int64_t ties = 0;
  std::int64_t wins_b = 0;
  std::int64_t only_a = 0;  // of wins_a: b did not reach the goal
  std::int64_t only_b = 0;
  Estimate win_share_a;             // wins_a of the pairs that one of the two won
  double success_p_holm = kAbsent;  // only_a against only_b, see ranks.h
  double path_p_holm = kAbsent;     // shorter_a() against shorter_b()

  // Both reached the goal.
  std::int64_t shorter_a() const { return wins_a - only_a; }
  std::int64_t shorter_b() const { return wins_b - only_b; }
};

struct SummaryConfig {
  double tie_tolerance = 0.01;  // relative, on the path ratio
  BootstrapConfig bootstrap;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("tie_tolerance", tie_tolerance, 0.0, 1.0);
    bootstrap.visit(v);
  }
};

struct Summary {
  std::vector<PlannerSummary> groups;    // by scenario group, vehicle, regulator, planner
  std::vector<PlannerSummary> totals;    // pooled, where a vehicle flew more than one group
  std::vector<PlannerPairing> pairings;  // per group, and pooled where there are totals
};

// Scenario groups are in natural order: "bearing-45" before "bearing-135". O(resamples * records).
Summary summarise(const std::vector<RunRecord>& records, const SummaryConfig& config = {});

}  // namespace voronaut
