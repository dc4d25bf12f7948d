#include "voronaut/benchmarks/suite/shared_references.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/tests/benchmarks/small_suite.h"
#include "voronaut/tests/support/temporary_folder.h"

namespace voronaut {
namespace {

// Two shards of a run, and what each of them had to compute.
class Shards : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(own_);
    std::filesystem::create_directory(other_);
    SuiteTrials trials(suite_);
    while (auto planned = trials.next())
      if (planned->spec.planner.label == "a") worlds_.push_back(planned->spec.scenario);
  }
  ShortestReferences::Length counted() {
    return [this](const Scenario& scenario, double radius_m) {
      ++computed_;
      return scenario.name == "open" ? std::nan("") : radius_m / 3 + computed_;
    };
  }

  TemporaryFolder folder_;
  std::filesystem::path own_ = folder_.path() / "1-of-2";
  std::filesystem::path other_ = folder_.path() / "2-of-2";
  SuiteConfig suite_ = small_suite("shared", {"a"}, 3);
  std::vector<Scenario> worlds_;
  int computed_ = 0;
};

TEST_F(Shards, ComputeWhatNoOtherHasComputedWhileTheyFly) {
  SharedReferences own(own_, "r.txt");
  SharedReferences other(other_, "r.txt");
  const auto of_own = own.sharing(counted());
  const auto of_other = other.sharing(counted());
  for (const Scenario& world : worlds_) {
    const double length_m = of_own(world, 0.25);
    const double again_m = of_other(world, 0.25);
    EXPECT_TRUE(length_m == again_m || (std::isnan(length_m) && std::isnan(again_m)));
  }
  EXPECT_EQ(computed_, 4);  // one open world, three forests
  of_other(worlds_.back(), 0.5);
  EXPECT_EQ(computed_, 5) << "another radius";
  SharedReferences stranger(own_, "other-build.txt");
  stranger.sharing(counted())(worlds_.back(), 0.25);
  EXPECT_EQ(computed_, 6) << "another build";
}

TEST_F(Shards, ShareHowHardAWorldIs) {
  SharedReferences own(own_, "r.txt");
  SharedReferences other(other_, "r.txt");
  const ShortestReferences::Difficulty counted = [this](const Scenario& scenario) {
    ++computed_;
    return WorldDifficulty{0.25, scenario.name == "open" ? kAbsent : 1.5};
  };
  const auto of_own = own.sharing(counted);
  const auto of_other = other.sharing(counted);
  for (const Scenario& world : worlds_) {
    of_own(world);
    const WorldDifficulty again = of_other(world);
    EXPECT_EQ(again.free_share, 0.25);
    EXPECT_EQ(std::isnan(again.narrowest_passage_m), world.name == "open");
    EXPECT_TRUE(world.name == "open" || again.narrowest_passage_m == 1.5);
  }
  EXPECT_EQ(computed_, 4) << "one open world, three forests";
}

TEST_F(Shards, PassOverLinesThatWereCutOffAnywhere) {
  double want_m = 0;
  {
    SharedReferences other(other_, "r.txt");
    want_m = other.sharing(counted())(worlds_.back(), 0.25);
  }
  std::stringstream text;
  text << std::ifstream(other_ / "r.txt").rdbuf();
  const std::string whole = text.str();
  ASSERT_GT(whole.size(), 70U);
  for (std::size_t size = 0; size < whole.size() - 1; ++size) {
    // Cut off, then the next run's line for something else behind it.
    std::ofstream(other_ / "r.txt") << whole.substr(0, size) << "\n0 0.25 7 end\n";
    computed_ = 99;
    SharedReferences own(own_, "r.txt");
    std::filesystem::remove(own_ / "r.txt");
    const double got_m = own.sharing(counted())(worlds_.back(), 0.25);
    EXPECT_EQ(computed_, 100) << "cut at " << size << ": took " << got_m << ", right is " << want_m;
  }
}

}  // namespace
}  // namespace voronaut
