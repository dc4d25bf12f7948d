#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "voronaut/reports/record_columns.h"
#include "voronaut/reports/summary/estimate.h"

// The one table of statistics: what is computed, of which trials, over what, which way is better,
// how it is written and where. Text, Markdown, JSON, CSV, acceptance criteria, the evidence page
// and the report iterate it.
namespace voronaut {

enum class Estimator { rate, mean, median, p95, smallest };

enum class Better { more, less, neither };

// Where a statistic is shown. JSON, CSV and acceptance criteria have them all.
using Output = unsigned;
inline constexpr Output kText = 1;         // voronaut run, summary, report --format md
inline constexpr Output kEvidence = 2;     // docs/evidence.md
inline constexpr Output kPage = 4;         // the report's table
inline constexpr Output kSweep = 8;        // the report's plots over a parameter
inline constexpr Output kComparison = 16;  // one run against another: the change of it

enum class Axis { linear, logarithmic };

// Of one trial: a column, or what is made of some; NaN where the trial has none.
using StatisticValue =
    std::variant<double RunRecord::*, std::int64_t RunRecord::*, double (*)(const RunRecord&)>;

struct Statistic {
  std::string_view name;  // key in JSON, CSV and, with _min or _max, of an acceptance criterion
  TrialSet trials;
  Estimator estimator;
  StatisticValue value;
  Better better;
  int digits;                      // after the point; of a rate those of its percentage
  std::string_view label;          // of what; the estimator and the unit are written beside it
  unsigned shown;                  // outputs
  std::string_view question = {};  // title of the plot of how its values spread; empty: none
  Axis axis = Axis::linear;
  std::string_view about = {};  // of a value that is no column
};

std::span<const Statistic> statistics();
std::vector<const Statistic*> statistics_shown(Output output);
// Throws std::invalid_argument for an unknown name.
const Statistic& statistic(std::string_view name);

// The column that it is over; null for a value that is no column.
const RecordColumn* column_of(const Statistic& statistic);
std::string_view unit_of(const Statistic& statistic);
std::string_view estimator_words(const Statistic& statistic);
// "median over trials that reached the goal: path flown, ..."
std::string description_of(const Statistic& statistic);

double value_of(const StatisticValue& value, const RunRecord& record);
double value_of(const Statistic& statistic, const RunRecord& record);

using Trials = std::vector<const RunRecord*>;

// O(resamples * trials).
Estimate estimate_of(const Statistic& statistic, const Trials& trials,
                     const BootstrapConfig& bootstrap = {});
// The same of the values of the trials that it is over.
Estimate estimate_of(const Statistic& statistic, std::vector<double> values,
                     const BootstrapConfig& bootstrap);

}  // namespace voronaut
