#include "voronaut/reports/summary/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <type_traits>

namespace voronaut {

namespace {

using enum TrialSet;
using enum Estimator;
using enum Better;
using R = RunRecord;

template <Outcome outcome>
double ended_as(const RunRecord& record) {
  return record.outcome == outcome ? 1 : 0;
}

// A trial that never started failed: it counts 0.
double spl_or_0(const RunRecord& record) { return std::isnan(record.spl) ? 0 : record.spl; }

// What a planner that keeps planning_clearance_m could have done at best. Below 1 only for a
// vehicle that came closer; NaN also where no path has that clearance. Where start and goal are one
// place, so are the references: then it is path_ratio.
double path_ratio_at_clearance(const RunRecord& record) {
  if (record.shortest_at_clearance_m == 0) return record.path_ratio;
  return record.path_ratio * record.shortest_length_m / record.shortest_at_clearance_m;
}

constexpr unsigned kEverywhere = kText | kPage | kSweep | kComparison;

// Name, trials, estimator, value, which way is better, digits, label, where it is shown; then the
// title of a plot of its values and the plot's axis. A new statistic is one line here.
const Statistic kStatistics[] = {
    // clang-format off
    {"goal_reached_share", all, rate, ended_as<Outcome::goal_reached>, more, 1, "goal reached", kEverywhere | kEvidence, "", Axis::linear, "ended at rest at the goal"},
    {"collision_share", all, rate, ended_as<Outcome::collision>, less, 1, "collisions", kPage | kEvidence, "", Axis::linear, "the body met an obstacle"},
    {"infeasible_share", all, rate, ended_as<Outcome::infeasible>, neither, 1, "infeasible", 0, "", Axis::linear, "the planner proved that there is no path"},
    {"path_ratio_median", goal_reached, median, &R::path_ratio, less, 3, "path ratio", kEverywhere, "How long are the paths?"},
    {"path_ratio_mean", goal_reached, mean, &R::path_ratio, less, 3, "path ratio", kEvidence},
    {"path_ratio_p95", goal_reached, p95, &R::path_ratio, less, 3, "path ratio", kText | kPage | kSweep | kEvidence},
    {"path_ratio_at_clearance_mean", goal_reached, mean, path_ratio_at_clearance, less, 3, "path ratio at planning_clearance_m", kEvidence, "", Axis::linear, "path flown, with the straight rest to the goal, over the shortest one at planning_clearance_m"},
    {"spl_mean", all, mean, spl_or_0, more, 3, "SPL", kText | kPage, "", Axis::linear, "success weighted by path length; a failure counts 0"},
    {"duration_median_s", goal_reached, median, &R::duration_s, less, 1, "time to goal", kEverywhere, "How long does it take?"},
    {"clearance_smallest_m", moved, smallest, &R::clearance_smallest_m, more, 3, "clearance", kText | kPage | kEvidence},
    {"clearance_median_m", moved, median, &R::clearance_smallest_m, more, 3, "clearance", kPage | kSweep, "How close do they come?"},
    {"speed_mean_median_m_s", moved, median, &R::speed_mean_m_s, more, 2, "mean speed", kText | kPage | kSweep, "How fast do they fly?"},
    {"tracking_error_rms_median_m", moved, median, &R::tracking_error_rms_m, less, 3, "tracking error", kPage},
    {"energy_median_j", goal_reached, median, &R::energy_j, less, 0, "energy", kPage},
    {"replans_median", all, median, &R::replans, neither, 0, "replans", kPage},
    {"state_checks_median", all, median, &R::state_checks, less, 0, "state checks", kPage | kSweep | kComparison, "How much work is it?", Axis::logarithmic},
    {"planning_time_us_median", moved, median, &R::planning_time_us_mean, less, 1, "planning time", kEverywhere, "What does planning cost?", Axis::logarithmic},
    {"step_time_us_median", moved, median, &R::step_time_us_mean, less, 1, "whole step", kPage},
    {"barn_score_mean", all, mean, &R::barn_score, more, 3, "BARN score", kText | kPage | kEvidence | kComparison},
    {"barn_pace_mean", goal_reached, mean, &R::barn_pace, more, 3, "BARN pace", kText | kPage | kEvidence | kComparison},
    // clang-format on
};

Estimate rate_of(const std::vector<double>& values) {
  return wilson_rate(std::llround(std::accumulate(values.begin(), values.end(), 0.0)),
                     static_cast<std::int64_t>(values.size()));
}

Estimate smallest_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  Estimate estimate;
  estimate.n = static_cast<std::int64_t>(values.size());
  if (!values.empty()) estimate.value = *std::min_element(values.begin(), values.end());
  return estimate;
}

}  // namespace

std::span<const Statistic> statistics() { return kStatistics; }

std::vector<const Statistic*> statistics_shown(Output output) {
  std::vector<const Statistic*> shown;
  for (const Statistic& one : kStatistics)
    if ((one.shown & output) != 0) shown.push_back(&one);
  return shown;
}

const Statistic& statistic(std::string_view name) {
  const auto found = std::find_if(std::begin(kStatistics), std::end(kStatistics),
                                  [&](const Statistic& one) { return one.name == name; });
  if (found == std::end(kStatistics))
    throw std::invalid_argument("no statistic '" + std::string(name) + "'");
  return *found;
}

const RecordColumn* column_of(const Statistic& statistic) {
  return std::visit(
      [](auto value) -> const RecordColumn* {
        if constexpr (std::is_member_pointer_v<decltype(value)>) return &column_of(value);
        return nullptr;
      },
      statistic.value);
}

std::string_view unit_of(const Statistic& statistic) {
  const RecordColumn* column = column_of(statistic);
  return column != nullptr ? column->unit : std::string_view();
}

std::string_view estimator_words(const Statistic& statistic) {
  switch (statistic.estimator) {
    case rate:
      return "share";
    case mean:
      return "mean";
    case median:
      return "median";
    case p95:
      return "95th percentile";
    case smallest:
      break;
  }
  return "smallest";
}

std::string description_of(const Statistic& statistic) {
  const RecordColumn* column = column_of(statistic);
  const std::string_view about = column != nullptr ? column->about : statistic.about;
  std::string text(estimator_words(statistic));
  text.append(" over ").append(words(statistic.trials)).append(": ").append(about);
  if (column != nullptr && column->kind == ColumnKind::measured) text += "; measured";
  return text;
}

double value_of(const StatisticValue& of, const RunRecord& record) {
  return std::visit(
      [&](auto value) {
        if constexpr (std::is_member_pointer_v<decltype(value)>) {
          return static_cast<double>(record.*value);
        } else {
          return value(record);
        }
      },
      of);
}

double value_of(const Statistic& statistic, const RunRecord& record) {
  return value_of(statistic.value, record);
}

Estimate estimate_of(const Statistic& statistic, const Trials& trials,
                     const BootstrapConfig& bootstrap) {
  std::vector<double> values;
  for (const RunRecord* trial : trials)
    if (statistic.trials != goal_reached || trial->outcome == Outcome::goal_reached)
      values.push_back(value_of(statistic, *trial));
  return estimate_of(statistic, std::move(values), bootstrap);
}

Estimate estimate_of(const Statistic& statistic, std::vector<double> values,
                     const BootstrapConfig& bootstrap) {
  switch (statistic.estimator) {
    case rate:
      return rate_of(values);
    case mean:
      return mean_estimate(std::move(values), bootstrap);
    case median:
      return quantile_estimate(std::move(values), 0.5, bootstrap);
    case p95:
      return quantile_estimate(std::move(values), 0.95, bootstrap);
    case smallest:
      break;
  }
  return smallest_of(std::move(values));
}

}  // namespace voronaut
