#include "voronaut/reports/summary/estimate.h"

#include <algorithm>
#include <cmath>

namespace voronaut {

namespace {

constexpr double kZ95 = 1.959963984540054;  // 97.5 % quantile of the normal distribution
constexpr double kTail = 0.025;

// SplitMix64 (Steele, Lea, Flood, doi:10.1145/2714064.2660195): a few lines, the same everywhere.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  // Uniform in [0, n), n < 2^32; the bias of the multiplication is below n / 2^32.
  std::size_t below(std::size_t n) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return static_cast<std::size_t>((z >> 32U) * n >> 32U);
  }

 private:
  std::uint64_t state_;
};

void drop_absent_and_sort(std::vector<double>& values) {
  std::erase_if(values, [](double v) { return std::isnan(v); });
  std::sort(values.begin(), values.end());
}

struct Position {
  std::size_t index;
  double fraction;
};

Position quantile_position(std::size_t n, double probability) {
  const double at = probability * static_cast<double>(n - 1);
  const auto index = static_cast<std::size_t>(at);
  return {std::min(index, n - 1), at - static_cast<double>(index)};
}

// Without a fraction the next order statistic may be infinite: do not multiply it by 0.
double interpolate(double low, double high, double fraction) {
  return fraction > 0 && low != high ? low + (high - low) * fraction : low;
}

template <class Statistic>
Estimate bootstrap(const std::vector<double>& sorted, const BootstrapConfig& config,
                   Statistic&& statistic) {
  Estimate estimate;
  estimate.n = static_cast<std::int64_t>(sorted.size());
  if (sorted.empty()) {
    return estimate;
  }
  estimate.value = statistic(std::vector<std::uint32_t>(sorted.size(), 1));
  if (config.resamples == 0) {
    return estimate;
  }
  if (sorted.size() < kFewestResampled) {
    estimate.too_few = sorted;
    return estimate;
  }
  SplitMix64 random(config.seed);
  std::vector<double> resampled;
  std::vector<std::uint32_t> counts(sorted.size());
  for (int i = 0; i < config.resamples; ++i) {
    std::fill(counts.begin(), counts.end(), 0U);
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      ++counts[random.below(sorted.size())];
    }
    resampled.push_back(statistic(counts));
  }
  std::sort(resampled.begin(), resampled.end());
  estimate.interval = {quantile_of_sorted(resampled, kTail),
                       quantile_of_sorted(resampled, 1.0 - kTail)};
  return estimate;
}

}  // namespace

Estimate wilson_rate(std::int64_t successes, std::int64_t n) {
  Estimate rate{kAbsent, {}, n, successes};
  if (n == 0) {
    return rate;
  }
  const auto count = static_cast<double>(n);
  const double p = static_cast<double>(successes) / count;
  const double z2 = kZ95 * kZ95;
  const double centre = (p + z2 / (2 * count)) / (1 + z2 / count);
  const double half =
      kZ95 * std::sqrt(p * (1 - p) / count + z2 / (4 * count * count)) / (1 + z2 / count);
  rate.value = p;
  rate.interval = {successes == 0 ? 0.0 : centre - half, successes == n ? 1.0 : centre + half};
  return rate;
}

double quantile_of_sorted(std::span<const double> sorted, double probability) {
  const auto [index, fraction] = quantile_position(sorted.size(), probability);
  return interpolate(sorted[index], sorted[std::min(index + 1, sorted.size() - 1)], fraction);
}

double quantile(std::vector<double> values, double probability) {
  if (values.empty()) return kAbsent;
  std::sort(values.begin(), values.end());
  return quantile_of_sorted(values, probability);
}

namespace {

// How often the values below a quantile come in a resample is binomial, and normal in the limit:
// the interval is between the order statistics there.
Estimate limit_of_quantile(std::span<const double> sorted, double probability) {
  const double half =
      kZ95 * std::sqrt(probability * (1 - probability) / static_cast<double>(sorted.size()));
  return {quantile_of_sorted(sorted, probability),
          {quantile_of_sorted(sorted, std::max(probability - half, 0.0)),
           quantile_of_sorted(sorted, std::min(probability + half, 1.0))},
          static_cast<std::int64_t>(sorted.size())};
}

// The mean of a resample is normal in the limit.
Estimate limit_of_mean(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0;
  for (const double value : values) mean += value;
  mean /= n;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const double half = kZ95 * std::sqrt(squares) / n;
  return {mean, {mean - half, mean + half}, static_cast<std::int64_t>(values.size())};
}

bool at_its_limit(const std::vector<double>& values, const BootstrapConfig& config) {
  return values.size() > kResampledMax && config.resamples > 0;
}

}  // namespace

double quantile_of_counts(std::span<const double> sorted, const std::vector<std::uint32_t>& counts,
                          double probability) {
  std::size_t drawn = 0;
  for (const std::uint32_t count : counts) drawn += count;
  if (drawn == 0) return kAbsent;
  const auto [index, fraction] = quantile_position(drawn, probability);
  std::size_t seen = 0;
  std::size_t k = 0;
  while (seen + counts[k] <= index) {
    seen += counts[k++];
  }
  const double low = sorted[k];
  while (seen + counts[k] <= std::min(index + 1, drawn - 1)) {
    seen += counts[k++];
  }
  return interpolate(low, sorted[k], fraction);
}

TestedEstimate bootstrap_test(const ResampledUnits& units, const ResampledValue& value,
                              const BootstrapConfig& config) {
  TestedEstimate tested;
  const std::size_t n = units.unit_of.size();
  tested.estimate.n = static_cast<std::int64_t>(n);
  if (n == 0) return tested;
  tested.estimate.value = value(std::vector<std::uint32_t>(n, 1));
  if (units.units < 2 || config.resamples == 0) return tested;
  SplitMix64 random(config.seed);
  std::vector<double> resampled;
  std::vector<std::uint32_t> drawn(units.units);
  std::vector<std::uint32_t> counts(n);
  for (int i = 0; i < config.resamples; ++i) {
    std::fill(drawn.begin(), drawn.end(), 0U);
    for (std::size_t k = 0; k < units.units; ++k) ++drawn[random.below(units.units)];
    for (std::size_t k = 0; k < n; ++k) counts[k] = drawn[units.unit_of[k]];
    if (const double one = value(counts); !std::isnan(one)) resampled.push_back(one);
  }
  if (resampled.empty()) return tested;
  std::sort(resampled.begin(), resampled.end());
  if (units.units >= kFewestResampled)
    tested.estimate.interval = {quantile_of_sorted(resampled, kTail),
                                quantile_of_sorted(resampled, 1.0 - kTail)};
  const auto at_most =
      std::upper_bound(resampled.begin(), resampled.end(), 0.0) - resampled.begin();
  const auto at_least = resampled.end() - std::lower_bound(resampled.begin(), resampled.end(), 0.0);
  const double rarer = static_cast<double>(std::min(at_most, at_least) + 1) /
                       static_cast<double>(resampled.size() + 1);
  const double least =
      std::ldexp(1.0, 1 - static_cast<int>(std::min<std::size_t>(units.units, 1000)));
  tested.p = std::clamp(2 * rarer, least, 1.0);
  return tested;
}

Estimate quantile_estimate(std::vector<double> values, double probability,
                           const BootstrapConfig& config) {
  drop_absent_and_sort(values);
  if (at_its_limit(values, config)) return limit_of_quantile(values, probability);
  return bootstrap(values, config, [&](const std::vector<std::uint32_t>& counts) {
    return quantile_of_counts(values, counts, probability);
  });
}

Estimate mean_estimate(std::vector<double> values, const BootstrapConfig& config) {
  drop_absent_and_sort(values);
  if (at_its_limit(values, config)) return limit_of_mean(values);
  return bootstrap(values, config, [&](const std::vector<std::uint32_t>& counts) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += counts[i] * values[i];
    }
    return sum / static_cast<double>(values.size());
  });
}

}  // namespace voronaut
