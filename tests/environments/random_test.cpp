#include "voronaut/environments/random.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace voronaut {
namespace {

// Golden values: the integers from an independent implementation of the published algorithms.
TEST(Random, DrawsTheSameIntegersEverywhere) {
  Random random(1);
  EXPECT_EQ(random.next(), 12966619160104079557U);
  EXPECT_EQ(random.next(), 9600361134598540522U);
  EXPECT_EQ(random.next(), 10590380919521690900U);
  EXPECT_EQ(random.next(), 7218738570589545383U);
}

TEST(Random, DrawsTheSameRealsEverywhere) {
  Random random(7);
  EXPECT_EQ(random.uniform(), 0x1.66b1f5ee9df2ep-1);
  EXPECT_EQ(random.uniform(-2, 3), -0x1.36659820e72e8p-1);
  Random normal(7);
  EXPECT_EQ(normal.normal(), -0x1.1db8771102afbp-2);
  EXPECT_EQ(normal.normal(), 0x1.e6573bcb6ffe2p+0);
}

TEST(Random, UniformsStayInsideTheirInterval) {
  Random random(3);
  double sum = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double value = random.uniform(-1, 3);
    ASSERT_GE(value, -1);
    ASSERT_LE(value, 3);
    sum += value;
  }
  EXPECT_NEAR(sum / 100'000, 1.0, 0.02);
}

TEST(Random, NormalsHaveMeanZeroAndVarianceOne) {
  Random random(5);
  double sum = 0;
  double squares = 0;
  int beyond_two = 0;
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.normal();
    ASSERT_TRUE(std::isfinite(value));
    sum += value;
    squares += value * value;
    beyond_two += std::abs(value) > 2 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1, 0.02);
  EXPECT_NEAR(static_cast<double>(beyond_two) / kDraws, 0.0455, 0.003);
}

TEST(Random, PicksEveryIndexEquallyOften) {
  Random random(11);
  std::vector<int> hits(7);
  for (int i = 0; i < 70'000; ++i) ++hits[random.below(7)];
  for (const int count : hits) EXPECT_NEAR(count, 10'000, 400);
  EXPECT_EQ(random.below(1), 0U);
}

TEST(Random, PicksWithoutBiasWhenTheBoundDoesNotDivideTheRange) {
  constexpr std::uint64_t kThird = std::uint64_t{1} << 62;
  Random random(13);
  int low = 0;
  for (int i = 0; i < 30'000; ++i) low += random.below(3 * kThird) < kThird ? 1 : 0;
  EXPECT_NEAR(low, 10'000, 300);  // 15'000 if the last, incomplete interval were taken too
}

// Golden values from an independent implementation of the stated hash.
TEST(DerivedSeed, IsTheStatedHash) {
  EXPECT_EQ(derive_seed(1, {"suite", "forest"}, 3), 4559222464316657305U);
  EXPECT_EQ(derive_seed(0, {}, 0), 1881740295411290639U);
}

TEST(DerivedSeed, KeepsTheNamesApart) {
  EXPECT_NE(derive_seed(1, {"suite", "forest"}, 3), derive_seed(1, {"suitef", "orest"}, 3));
  EXPECT_NE(derive_seed(1, {"a", "b"}, 3), derive_seed(1, {"b", "a"}, 3));
  std::set<std::uint64_t> seeds;
  for (std::uint64_t suite = 0; suite < 100; ++suite)
    for (std::uint64_t index = 0; index < 100; ++index)
      seeds.insert(derive_seed(suite, {"forest"}, index));
  EXPECT_EQ(seeds.size(), 10'000U);
  EXPECT_GT(*seeds.begin(), 0U);
  EXPECT_LT(*seeds.rbegin(), std::uint64_t{1} << 62);
}

}  // namespace
}  // namespace voronaut
