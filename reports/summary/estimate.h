#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "voronaut/reports/run_record.h"

// Estimates with 95 % intervals. Pure functions; the same input gives the same bits.
namespace voronaut {

struct Interval {
  double low = kAbsent;
  double high = kAbsent;
};

// A number over n values, with its interval: Wilson's of a rate, else bootstrapped. Absent for n =
// 0; of what is bootstrapped also the interval for n < kFewestResampled.
struct Estimate {
  double value = kAbsent;
  Interval interval;
  std::int64_t n = 0;
  std::int64_t successes = 0;  // of a rate: value = successes / n
  // All n values, ascending, where they are too few for the interval that is asked for.
  std::vector<double> too_few = {};
};

// Fewer values have no interval: even smallest to largest misses the median with probability
// 2^(1 - n), which is above 5 % then, and no test of their signs can say 5 %.
inline constexpr std::size_t kFewestResampled = 6;

// Wilson's score interval (E. B. Wilson, J. Am. Stat. Assoc. 22, 1927, doi:10.2307/2276774), which
// stays inside [0, 1] and is not of zero width at 0 or n successes.
Estimate wilson_rate(std::int64_t successes, std::int64_t n);

struct BootstrapConfig {
  int resamples = 1000;  // 0: no interval
  std::uint64_t seed = 20'240'229;

  template <class Visitor>
  void visit(Visitor& v) {
    v.count("resamples", resamples, 0, 100'000);
  }
};

// Quantile with linear interpolation between order statistics (Hyndman and Fan's type 7,
// doi:10.2307/2684934). `sorted` ascends, is not empty, `probability` is in [0, 1].
double quantile_of_sorted(std::span<const double> sorted, double probability);
// The same of values in any order; NaN for none. O(n log n).
double quantile(std::vector<double> values, double probability);

// A bootstrapped value with the two-sided p value of "it is 0" that goes with its interval: below
// 5 % where the interval leaves 0 out. No interval of fewer units than kFewestResampled. p is never
// below 2^(1 - units), which is what any test can say
// that only takes differences of either sign for equally likely.
struct TestedEstimate {
  Estimate estimate;
  double p = kAbsent;
};

// Which of the values were drawn together: `unit_of[i]` of value i, numbered from 0.
struct ResampledUnits {
  std::vector<std::size_t> unit_of;
  std::size_t units = 0;
};

// A value of a resample, from how often each of the n values was drawn; NaN where it has none.
using ResampledValue = std::function<double(const std::vector<std::uint32_t>& counts)>;
TestedEstimate bootstrap_test(const ResampledUnits& units, const ResampledValue& value,
                              const BootstrapConfig& config);

// Quantile of `sorted` values of which each was drawn so many times; NaN if none was.
double quantile_of_counts(std::span<const double> sorted, const std::vector<std::uint32_t>& counts,
                          double probability);

// Percentile bootstrap over the given values (B. Efron, Ann. Stat. 7, 1979,
// doi:10.1214/aos/1176344552), O(resamples * n); of more than kResampledMax values what that tends
// to for many values and resamples, O(n log n). Values that are NaN are left out and not counted.
inline constexpr std::size_t kResampledMax = 20'000;
Estimate quantile_estimate(std::vector<double> values, double probability,
                           const BootstrapConfig& config = {});
Estimate mean_estimate(std::vector<double> values, const BootstrapConfig& config = {});

}  // namespace voronaut
