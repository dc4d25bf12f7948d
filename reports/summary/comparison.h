#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/estimate.h"
#include "voronaut/reports/summary/paired_trials.h"
#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/summary.h"

// One set of trials against another: what changed, and is it chance? Trials are paired by (scenario
// group, scenario, vehicle, regulator, planner, repetition).
namespace voronaut {

enum class ChangeVerdict { undecided, better, worse };

// Of one statistic, now against before: of a rate the difference, else relative (0.01 is one
// percent more): of a median the median over the pairs, else that of the two statistics over the
// pairs.
struct Change : Estimate {
  double p = kAbsent;        // two-sided: McNemar's exact test of a rate, else bootstrapped
  double p_holm = kAbsent;   // corrected over all changes of the comparison
  bool over_worlds = false;  // what was resampled: worlds, else pairs
  // Better or worse: p_holm is below 5 % and the interval lies beyond the tolerance.
  ChangeVerdict verdict = ChangeVerdict::undecided;
  double repetitions_needed = kAbsent;  // to see a change of the tolerance in 80 % of runs
};

struct RunComparison;

struct PlannerChange {
  SummaryGroup group;
  std::string planner;
  std::int64_t n = 0;        // pairs
  std::int64_t changed = 0;  // of them flew differently
  Estimate reached_before;
  Estimate reached_now;
  std::int64_t gained = 0;      // failed before, reaches the goal now
  std::int64_t lost = 0;        // the other way round
  std::vector<Change> changes;  // in the order of RunComparison::statistics

  // Of a statistic that is compared.
  const Change& of(const RunComparison& comparison, std::string_view statistic) const;
};

struct OutcomeChange {
  Outcome outcome_before = Outcome::invalid;
  RunRecord now;
};

struct RunComparison {
  std::string title;   // of what came before
  std::string commit;  // of the program that flew it; empty: unknown
  double tolerance = 0;
  std::vector<const Statistic*> statistics;  // that are compared
  std::int64_t pairs = 0;
  std::int64_t changed = 0;             // pairs that flew differently
  std::int64_t only_here = 0;           // trials now without a partner
  std::int64_t only_there = 0;          // trials before without one
  std::int64_t ended_differently = 0;   // pairs
  std::vector<PlannerChange> changes;   // by scenario group, vehicle, regulator, planner
  std::vector<OutcomeChange> outcomes;  // of these, see kOutcomeChangesMax, by trial_id

  bool worse() const;  // by any statistic
};

// Whether two trials flew alike, whatever their planners are called.
using SameFlight = std::function<bool(const RunRecord& a, const RunRecord& b)>;

struct ComparisonConfig {
  std::vector<const Statistic*> statistics = statistics_shown(kComparison);
  double tolerance = 0;         // a share of 1: points of a rate, relative of the rest
  SameFlight same_flight = {};  // none: all pairs count as changed
  BootstrapConfig bootstrap = {.resamples = 10'000};
};

// Pairs that end differently are listed, if there are more, those of the lowest repetitions.
inline constexpr std::size_t kOutcomeChangesMax = 2000;

// The worlds of a group are resampled, each with all of its pairs; where they are fewer than
// kFewestWorlds the pairs are, and what is said is about these worlds alone. O(resamples * n), the
// resamples fewer where n is large. Both runs come in kPairingOrder; PairedTrials says what is in
// memory, for one planner at a time. Leaves title and commit empty.
RunComparison compare_runs(const NextRecord& now, const NextRecord& before,
                           const ComparisonConfig& config = {});
// The same of records in any order.
RunComparison compare_runs(const std::vector<RunRecord>& now, const std::vector<RunRecord>& before,
                           const ComparisonConfig& config = {});

}  // namespace voronaut
