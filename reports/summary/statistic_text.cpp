#include "voronaut/reports/summary/statistic_text.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

namespace voronaut {

namespace {

bool is_rate(const Statistic& statistic) { return statistic.estimator == Estimator::rate; }

// A share is written as a percentage.
std::string number(const Statistic& statistic, double value) {
  return fixed(is_rate(statistic) ? 100 * value : value, statistic.digits);
}

std::string brackets(const Interval& interval, double scale, int digits) {
  if (std::isnan(interval.low)) return "";
  return " [" + fixed(scale * interval.low, digits) + ", " + fixed(scale * interval.high, digits) +
         "]";
}

std::string rate_interval(const Statistic& statistic, const Estimate& estimate) {
  return brackets(estimate.interval, 100, statistic.digits);
}

std::string over(const Statistic& statistic, const Estimate& estimate,
                 const OutcomeCounts& counts) {
  const std::int64_t expected = statistic.trials == TrialSet::goal_reached
                                    ? counts.front()
                                    : std::accumulate(counts.begin(), counts.end(), std::int64_t{});
  return estimate.n == expected ? "" : " over " + std::to_string(estimate.n);
}

}  // namespace

std::string fixed(double value, int digits) {
  if (std::isnan(value)) return "-";
  double halves = 2;  // of the last digit, in one
  for (int i = 0; i < digits; ++i) halves *= 10;
  // printf takes an exact half to the even digit; the smallest bit more it takes up.
  const double count = halves * value;
  const bool is_half = std::fma(halves, value, -count) == 0 && std::fmod(std::abs(count), 2) == 1;
  const double away = std::copysign(std::numeric_limits<double>::infinity(), value);
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, is_half ? std::nextafter(value, away) : value);
  return text;
}

std::string spread_text(const Estimate& estimate, int digits) {
  if (estimate.too_few.empty()) return brackets(estimate.interval, 1, digits);
  if (estimate.too_few.size() == 1) return " (one value)";
  std::string text;
  for (const double value : estimate.too_few)
    text.append(text.empty() ? " (too few: " : ", ").append(fixed(value, digits));
  return text + ")";
}

std::string heading(const Statistic& statistic) {
  std::string text(statistic.label);
  text.append("\n").append(estimator_words(statistic));
  if (const std::string_view unit = unit_of(statistic); !unit.empty())
    text.append(", ").append(unit);
  return text;
}

OutcomeCounts outcome_counts(const Trials& trials) {
  OutcomeCounts counts{};
  for (const RunRecord* trial : trials) ++counts[static_cast<std::size_t>(trial->outcome)];
  return counts;
}

std::string brief_text(const Statistic& statistic, const Estimate& estimate,
                       const OutcomeCounts& counts) {
  if (estimate.n == 0) return "-";
  return number(statistic, estimate.value) +
         (is_rate(statistic) ? " %" + rate_interval(statistic, estimate) : "") +
         over(statistic, estimate, counts);
}

std::string full_text(const Statistic& statistic, const Estimate& estimate,
                      const OutcomeCounts& counts) {
  if (estimate.n == 0) return "-";
  if (is_rate(statistic))
    return std::to_string(estimate.successes) + " of " + std::to_string(estimate.n) + ", " +
           brief_text(statistic, estimate, counts);
  return number(statistic, estimate.value) + spread_text(estimate, statistic.digits) +
         over(statistic, estimate, counts);
}

std::string other_outcomes(const OutcomeCounts& counts, Output output, bool flown) {
  std::string shown;
  for (const Statistic* statistic : statistics_shown(output))
    shown.append(statistic->name).append(" ");
  std::string text;
  for (const OutcomeEntry& entry : kOutcomes) {
    const std::int64_t count = counts[static_cast<std::size_t>(entry.outcome)];
    if (count == 0 || shown.find(std::string(entry.name) + "_share ") != std::string::npos)
      continue;
    text.append(text.empty() ? "" : ", ").append(std::to_string(count)).append(" ");
    text.append(!flown && entry.outcome == Outcome::timeout ? "budget spent" : entry.words);
  }
  return text;
}

}  // namespace voronaut
