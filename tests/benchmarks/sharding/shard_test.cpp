#include "voronaut/benchmarks/suite/shard.h"

#include <cmath>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/benchmarks/trial/sha256.h"
#include "voronaut/tests/benchmarks/small_suite.h"

namespace voronaut {
namespace {

TEST(Shard, IsReadAsItIsWrittenAndRefusesWhatIsNone) {
  EXPECT_EQ(Shard::parse("2/8").text(), "2/8");
  EXPECT_EQ(Shard::parse("1/1").folder_name(), "1-of-1");
  for (const char* text : {"", "2", "/", "0/3", "4/3", "2/", "/2", "-1/3", "1/3x", "1 /3", "1/2/3",
                           "1/100001", "99999999999999999999/3"}) {
    try {
      Shard::parse(text);
      ADD_FAILURE() << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "--shard: expected i/n with 1 <= i <= n <= 100000, got '" +
                                  std::string(text) + "'");
    }
  }
}

TEST(Shard, HoldsEachTrialOnceAndAboutAsManyAsTheOthers) {
  for (const std::size_t count : {1U, 2U, 7U, 32U}) {
    std::vector<int> held(count, 0);
    for (int i = 0; i < 3200; ++i) {
      const std::string id = sha256_hex(std::to_string(i));
      for (std::size_t number = 1; number <= count; ++number)
        held[number - 1] += Shard{number, count}.holds(id) ? 1 : 0;
    }
    int all = 0;
    for (const int n : held) {
      all += n;
      EXPECT_NEAR(n, 3200.0 / static_cast<double>(count),
                  6 * std::sqrt(3200.0 / static_cast<double>(count)));
    }
    EXPECT_EQ(all, 3200);
  }
}

std::vector<std::string> ids_of(const SuiteConfig& suite, Shard shard) {
  std::vector<std::string> ids;
  SuiteTrials trials(suite, nullptr, shard);
  while (const auto planned = trials.next()) ids.push_back(planned->spec.trial_id);
  return ids;
}

TEST(ShardOfASuite, HasTheTrialsThatItHoldsWhereverItBegins) {
  const SuiteConfig suite = small_suite("parts", {"a", "b", "c"}, 5);
  const auto all = ids_of(suite, {});
  ASSERT_EQ(all.size(), 30U);
  for (std::size_t number = 1; number <= 4; ++number) {
    const Shard shard{number, 4};
    std::set<std::string> wanted;
    for (const std::string& id : all)
      if (shard.holds(id)) wanted.insert(id);
    const auto got = ids_of(suite, shard);
    EXPECT_EQ(got.size(), wanted.size());
    EXPECT_EQ(std::set<std::string>(got.begin(), got.end()), wanted);
  }
}

TEST(ShardOfASuite, BeginsWithWorldsOfItsOwn) {
  const SuiteConfig suite = small_suite("parts", {"a", "b", "c", "d", "e", "f", "g", "h"}, 4);
  std::set<std::string> first_worlds;
  for (std::size_t number = 1; number <= 4; ++number) {
    SuiteTrials trials(suite, nullptr, {number, 4});
    const auto planned = trials.next();
    ASSERT_TRUE(planned);
    first_worlds.insert(planned->spec.scenario.name + std::to_string(planned->spec.repetition));
  }
  EXPECT_EQ(first_worlds.size(), 4U);
}

}  // namespace
}  // namespace voronaut
