#include "voronaut/reports/summary/significance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voronaut {

namespace {

constexpr double kZ975 = 1.959963984540054;  // 97.5 % quantile of the normal distribution
constexpr double kZ80 = 0.8416212335729143;  // its 80 % quantile

// Newcombe's phi: how much the two shares go together, corrected for continuity where positive.
double phi_of(double both, double lost, double gained, double neither) {
  const double product = (both + lost) * (gained + neither) * (both + gained) * (lost + neither);
  if (product == 0) return 0;
  double together = both * neither - lost * gained;
  const double half_n = (both + lost + gained + neither) / 2;
  if (together > 0) together = std::max(together - half_n, 0.0);
  return together / std::sqrt(product);
}

}  // namespace

double mcnemar_exact(std::int64_t gained, std::int64_t lost) {
  const std::int64_t n = gained + lost;
  const std::int64_t fewer = std::min(gained, lost);
  double tail = 0;
  // Logarithms: 0.5^n is 0 in a double from n = 1075 on. The factorials by sums, as lgamma depends
  // on the library.
  double log_term = -static_cast<double>(n) * std::log(2.0);
  for (std::int64_t k = 0; k <= fewer; ++k) {
    tail += std::exp(log_term);
    log_term += std::log(static_cast<double>(n - k)) - std::log(static_cast<double>(k + 1));
  }
  return std::min(1.0, 2 * tail);
}

Estimate paired_share_difference(std::int64_t both, std::int64_t gained, std::int64_t lost,
                                 std::int64_t n) {
  Estimate difference;
  difference.n = n;
  if (n == 0) return difference;
  const Estimate now = wilson_rate(both + gained, n);
  const Estimate before = wilson_rate(both + lost, n);
  difference.value = static_cast<double>(gained - lost) / static_cast<double>(n);
  const double phi =
      phi_of(static_cast<double>(both), static_cast<double>(lost), static_cast<double>(gained),
             static_cast<double>(n - both - gained - lost));
  const auto half = [phi](double a, double b) {
    return std::sqrt(std::max(0.0, a * a - 2 * phi * a * b + b * b));
  };
  difference.interval = {
      difference.value - half(now.value - now.interval.low, before.interval.high - before.value),
      difference.value + half(before.value - before.interval.low, now.interval.high - now.value)};
  return difference;
}

std::vector<double> holm_corrected(const std::vector<double>& p_values) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p_values.size(); ++i)
    if (!std::isnan(p_values[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> corrected(p_values.size(), kAbsent);
  double highest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    highest = std::max(highest, static_cast<double>(order.size() - rank) * p_values[order[rank]]);
    corrected[order[rank]] = std::min(1.0, highest);
  }
  return corrected;
}

double pairs_needed_of_share(double differing_share, double tolerance) {
  if (!(tolerance > 0)) return kAbsent;
  const double differing = std::max(differing_share, tolerance);  // what a difference takes
  const double root =
      kZ975 * std::sqrt(differing) + kZ80 * std::sqrt(differing - tolerance * tolerance);
  return std::ceil(root * root / (tolerance * tolerance));
}

double pairs_needed(const Estimate& difference, double tolerance) {
  const double width = difference.interval.high - difference.interval.low;
  if (!(tolerance > 0) || !(width > 0)) return kAbsent;
  const double error_of_one = width / (2 * kZ975) * std::sqrt(static_cast<double>(difference.n));
  const double root = (kZ975 + kZ80) * error_of_one / tolerance;
  return std::ceil(root * root);
}

}  // namespace voronaut
