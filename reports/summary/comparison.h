#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/estimate.h"
#include "voronaut/reports/summary/summary.h"

// One run against another: what changed, over trials paired by (scenario group, scenario, vehicle,
// regulator, planner, repetition).
namespace voronaut {

// Changes are "now" against "before": of a rate as a difference, of the rest relative (0.01 is one
// percent more). A change whose interval leaves zero out is one the data can tell from chance.
struct PlannerChange {
  SummaryGroup group;
  std::string planner;
  std::int64_t n = 0;  // pairs
  Estimate reached_before;
  Estimate reached_now;
  std::int64_t gained = 0;  // failed before, reaches the goal now
  std::int64_t lost = 0;    // the other way round
  // In the order of statistics_shown(kComparison): of a rate the mean over the pairs, else the
  // median over those whose two trials both have the value.
  std::vector<Estimate> changes;

  // By the name of the statistic; std::invalid_argument for one that is not compared.
  const Estimate& of(std::string_view statistic) const;
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
