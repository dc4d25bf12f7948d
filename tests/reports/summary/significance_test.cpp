#include "voronaut/reports/summary/significance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

TEST(McNemar, IsTheSignTestOfThePairsThatDiffer) {
  EXPECT_EQ(mcnemar_exact(0, 0), 1);
  EXPECT_NEAR(mcnemar_exact(5, 0), 2.0 / 32, 1e-12);
  EXPECT_NEAR(mcnemar_exact(0, 6), 2.0 / 64, 1e-12);
  EXPECT_NEAR(mcnemar_exact(1, 7), 2.0 * (1 + 8) / 256, 1e-12);
  EXPECT_NEAR(mcnemar_exact(8, 2), 2.0 * (1 + 10 + 45) / 1024, 1e-12);
  EXPECT_EQ(mcnemar_exact(4, 4), 1);
}

TEST(McNemar, HoldsForManyMorePairsThanADoubleHasPowersOfTwo) {
  EXPECT_GT(mcnemar_exact(10'000, 10'000), 0.99);
  EXPECT_NEAR(mcnemar_exact(10'100, 9'900), 0.1594, 0.001);  // normal, corrected: z = 199 / 141.42
}

// Newcombe's table II, method 10.
TEST(PairedShares, HaveNewcombesInterval) {
  const Estimate same = paired_share_difference(36, 12, 2, 50);
  EXPECT_NEAR(same.value, 0.20, 1e-12);
  EXPECT_NEAR(same.interval.low, 0.0569, 0.0005);
  EXPECT_NEAR(same.interval.high, 0.3404, 0.0005);
  // Where the two shares go together, corrected for continuity.
  const Estimate together = paired_share_difference(20, 12, 2, 50);
  EXPECT_NEAR(together.interval.low, 0.0562, 0.0005);
  EXPECT_NEAR(together.interval.high, 0.3292, 0.0005);
}

TEST(PairedShares, AreNotCertainWhereNothingDiffers) {
  const Estimate same = paired_share_difference(10, 0, 0, 10);
  EXPECT_EQ(same.value, 0);
  EXPECT_LT(same.interval.low, -0.2);
  EXPECT_GT(same.interval.high, 0.2);
  EXPECT_TRUE(std::isnan(paired_share_difference(0, 0, 0, 0).value));
}

TEST(Holm, CorrectsStepByStepFromTheSmallest) {
  const auto p = holm_corrected({0.01, 0.04, 0.03, 0.005});
  EXPECT_NEAR(p[3], 0.02, 1e-12);
  EXPECT_NEAR(p[0], 0.03, 1e-12);
  EXPECT_NEAR(p[2], 0.06, 1e-12);
  EXPECT_NEAR(p[1], 0.06, 1e-12) << "never below the one before it";
}

TEST(Holm, DoesNotCountWhatWasNotTested) {
  const auto p = holm_corrected({kAbsent, 0.02, 0.9});
  EXPECT_TRUE(std::isnan(p[0]));
  EXPECT_NEAR(p[1], 0.04, 1e-12);
  EXPECT_NEAR(p[2], 0.9, 1e-12);
}

TEST(PairsNeeded, FallWithTheSquareOfTheTolerance) {
  const Estimate difference{0, {-0.1, 0.1}, 100, 0};
  // ((1.960 + 0.842) * 0.0510 * 10 / 0.1)^2
  EXPECT_EQ(pairs_needed(difference, 0.1), 205);
  EXPECT_NEAR(pairs_needed(difference, 0.05) / pairs_needed(difference, 0.1), 4, 0.05);
  EXPECT_TRUE(std::isnan(pairs_needed(difference, 0)));
  EXPECT_TRUE(std::isnan(pairs_needed({0, {0, 0}, 9, 0}, 0.1)));
  // (1.960 sqrt(0.2) + 0.842 sqrt(0.2 - 0.01))^2 / 0.01
  EXPECT_EQ(pairs_needed_of_share(0.2, 0.1), 155);
}

}  // namespace
}  // namespace voronaut
