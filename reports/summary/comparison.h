#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/summary.h"

// One run against another: what changed, over trials paired by (scenario group, scenario, vehicle,
// regulator, planner, repetition).
namespace voronaut {

// Changes are "now" against "before": of success as a difference, of the rest relative (0.01 is one
// percent more). A change whose interval leaves zero out is one the data can tell from chance.
struct PlannerChange {
  SummaryGroup group;
  std::string planner;
  std::int64_t n = 0;  // pairs
  Rate reached_before;
  Rate reached_now;
  std::int64_t gained = 0;        // failed before, reaches the goal now
  std::int64_t lost = 0;          // the other way round
  Estimate success_change;        // mean over all pairs
  Estimate path_ratio_change;     // median over pairs that both reached the goal
  Estimate duration_change;       // the same
  Estimate state_checks_change;   // median over all pairs that counted any before
  Estimate planning_time_change;  // the same; measured
};

struct OutcomeChange {
  Outcome outcome_before = Outcome::invalid;
  RunRecord now;
};

struct RunComparison {
  std::string title;                    // of the run before
  std::string commit;                   // of the program that flew it; empty: unknown
  std::int64_t only_here = 0;           // trials now without a partner
  std::int64_t only_there = 0;          // trials before without one
  std::vector<PlannerChange> changes;   // by scenario group, vehicle, regulator, planner
  std::vector<OutcomeChange> outcomes;  // pairs that end differently, in the order of `now`
};

// O(resamples * n). Leaves title and commit empty.
RunComparison compare_runs(const std::vector<RunRecord>& now, const std::vector<RunRecord>& before,
                           const BootstrapConfig& bootstrap = {});

}  // namespace voronaut
