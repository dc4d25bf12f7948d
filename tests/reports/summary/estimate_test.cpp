#include "voronaut/reports/summary/estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(WilsonRate, MatchesPublishedValues) {
  // Brown, Cai, DasGupta (2001), doi:10.1214/ss/1009213286, and hand calculation.
  const Estimate half = wilson_rate(5, 10);
  EXPECT_NEAR(half.interval.low, 0.2366, 5e-5);
  EXPECT_NEAR(half.interval.high, 0.7634, 5e-5);
  const Estimate all = wilson_rate(10, 10);
  EXPECT_NEAR(all.interval.low, 0.7225, 5e-5);
  EXPECT_EQ(all.interval.high, 1.0);
  const Estimate none = wilson_rate(0, 10);
  EXPECT_EQ(none.interval.low, 0.0);
  EXPECT_NEAR(none.interval.high, 0.2775, 5e-5);
  EXPECT_TRUE(std::isnan(wilson_rate(0, 0).value));
}

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  const std::vector<double> v{1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(quantile_of_sorted(v, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(v, 0.95), 3.85);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(v, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(v, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(std::vector{7.0}, 0.3), 7.0);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(QuantileEstimate, LeavesAbsentValuesOutAndCountsTheRest) {
  const Estimate e = quantile_estimate({3, kAbsent, 1, 2, kAbsent, 6, 5, 4, 7}, 0.5);
  EXPECT_EQ(e.n, 7);
  EXPECT_DOUBLE_EQ(e.value, 4.0);
  EXPECT_GE(e.interval.low, 1.0);
  EXPECT_LE(e.interval.high, 7.0);
  const Estimate nothing = quantile_estimate({kAbsent}, 0.5);
  EXPECT_EQ(nothing.n, 0);
  EXPECT_TRUE(std::isnan(nothing.value));
}

TEST(QuantileEstimate, HasNoIntervalWithoutResamples) {
  const Estimate e = quantile_estimate({3, 1, 2}, 0.5, {.resamples = 0});
  EXPECT_DOUBLE_EQ(e.value, 2.0);
  EXPECT_TRUE(std::isnan(e.interval.low));
}

TEST(QuantileEstimate, TheBootstrapMatchesPlainResampling) {
  // The counting form against the form of the textbook, on the same draws' distribution.
  std::mt19937_64 engine(11);
  std::vector<double> values;
  for (int i = 0; i < 60; ++i) {
    values.push_back(static_cast<double>(engine() % 1000));
  }
  std::vector<double> medians;
  for (int i = 0; i < 20'000; ++i) {
    std::vector<double> resample;
    for (std::size_t k = 0; k < values.size(); ++k) {
      resample.push_back(values[engine() % values.size()]);
    }
    std::sort(resample.begin(), resample.end());
    medians.push_back(quantile_of_sorted(resample, 0.5));
  }
  std::sort(medians.begin(), medians.end());
  const Estimate e = quantile_estimate(values, 0.5, {.resamples = 20'000});
  EXPECT_NEAR(e.interval.low, quantile_of_sorted(medians, 0.025), 25.0);
  EXPECT_NEAR(e.interval.high, quantile_of_sorted(medians, 0.975), 25.0);
}

TEST(QuantileEstimate, IsTheSameOnEveryCall) {
  const std::vector<double> values{5, 1, 4, 1, 5, 9, 2, 6};
  const Estimate a = quantile_estimate(values, 0.95);
  const Estimate b = quantile_estimate({9, 6, 5, 5, 4, 2, 1, 1}, 0.95);
  EXPECT_EQ(a.interval.low, b.interval.low);
  EXPECT_EQ(a.interval.high, b.interval.high);
}

TEST(MeanEstimate, DrawsEveryValue) {
  EXPECT_LT(mean_estimate({0, 1, 1, 1, 1, 1}).interval.low, 1);
  EXPECT_GT(mean_estimate({0, 0, 0, 0, 0, 1}).interval.high, 0);
}

TEST(MeanEstimate, OfFewerThanSixValuesHasTheValuesAndNoInterval) {
  const Estimate five = mean_estimate({5, 4, kAbsent, 3, 2, 1});
  EXPECT_TRUE(std::isnan(five.interval.low));
  EXPECT_TRUE(std::isnan(five.interval.high));
  EXPECT_EQ(five.too_few, (std::vector<double>{1, 2, 3, 4, 5}));
  EXPECT_EQ(quantile_estimate({7}, 0.5).too_few, std::vector<double>{7});
  const Estimate six = quantile_estimate({1, 2, 3, 4, 5, 6}, 0.5);
  EXPECT_FALSE(std::isnan(six.interval.low));
  EXPECT_TRUE(six.too_few.empty());
  EXPECT_FALSE(std::isnan(wilson_rate(1, 2).interval.low)) << "a share has one at any n";
}

TEST(BootstrapTest, OfFewerThanSixUnitsHasNoIntervalAndNoPBelowFivePercent) {
  for (const std::size_t n : {5U, 6U}) {
    ResampledUnits units;
    units.units = n;
    for (std::size_t i = 0; i < n; ++i) units.unit_of.push_back(i);
    const TestedEstimate one = bootstrap_test(units, [](const auto&) { return 1.0; }, {});
    EXPECT_EQ(std::isnan(one.estimate.interval.low), n == 5) << n;
    EXPECT_EQ(one.p < 0.05, n == 6) << n;
  }
}

TEST(MeanEstimate, CoversTheMeanOfManySamplesAtItsRate) {
  std::mt19937_64 engine(3);
  int covered = 0;
  constexpr int kRounds = 300;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> values;
    for (int i = 0; i < 40; ++i) {
      values.push_back(static_cast<double>(engine() >> 11U) * 0x1p-53);
    }
    const Estimate e = mean_estimate(values, {.resamples = 300});
    covered += e.interval.low <= 0.5 && 0.5 <= e.interval.high;
  }
  EXPECT_GT(covered, kRounds * 0.89);
  EXPECT_LT(covered, kRounds * 0.99);
}

}  // namespace
}  // namespace voronaut
