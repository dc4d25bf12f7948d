#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/estimate.h"
#include "voronaut/reports/summary/statistics.h"

// Two runs side by side, one pair of trials after another: a million pairs need not be in memory as
// records.
namespace voronaut {

// One record at each call, nothing at the end.
using NextRecord = std::function<std::optional<RunRecord>()>;

// What a trial is paired by, in the order in which runs to pair must come; as SQL's ORDER BY.
inline constexpr const char* kPairingOrder =
    "scenario_group, vehicle, regulator, planner, scenario, repetition, trial_id";
bool before_in_pairing(const RunRecord& a, const RunRecord& b);

struct Unpaired {
  std::int64_t before = 0;
  std::int64_t now = 0;
};

// Both runs in kPairingOrder; of records of `before` that agree in what is paired by the first one
// counts. O(n) with two records in memory.
Unpaired for_each_pair(
    const NextRecord& before, const NextRecord& now,
    const std::function<void(const RunRecord& before, const RunRecord& now)>& use);

// The values of a statistic of the pairs that both have it, and what is resampled of them: worlds,
// each with all of its pairs, where they are kFewestWorlds or more, else pairs.
struct PairedValues {
  std::vector<double> before, now;
  ResampledUnits units;
  bool over_worlds = false;

  std::size_t size() const { return now.size(); }
};
inline constexpr std::size_t kFewestWorlds = kFewestResampled;

// Of a rate.
struct PairedCounts {
  std::int64_t n = 0;
  std::int64_t both = 0;
  std::int64_t gained = 0;  // now alone
  std::int64_t lost = 0;    // before alone
};

// What the comparison of one planner in one group needs of its pairs: 16 bytes for each pair and
// value that is no rate, and 12 more.
class PairedTrials {
 public:
  explicit PairedTrials(const std::vector<const Statistic*>& statistics);
  void add(const RunRecord& before, const RunRecord& now);

  std::int64_t size() const { return static_cast<std::int64_t>(world_of_.size()); }
  const PairedCounts& counts_of(std::size_t statistic) const { return rates_[statistic]; }
  PairedValues values_of(std::size_t statistic) const;
  double pairs_at_once() const;  // pairs of a repetition

 private:
  struct Column {
    StatisticValue value;
    std::deque<double> before, now;
  };

  const std::vector<const Statistic*>& statistics_;
  std::vector<PairedCounts> rates_;     // of each statistic; zeros if it is no rate
  std::vector<std::size_t> column_of_;  // of each statistic; not of a rate
  std::vector<Column> columns_;
  std::deque<bool> both_reached_;
  std::deque<std::uint32_t> world_of_;
  std::unordered_map<std::size_t, std::uint32_t> worlds_;  // by the hash of the id
  std::deque<std::int64_t> repetitions_;
};

}  // namespace voronaut
