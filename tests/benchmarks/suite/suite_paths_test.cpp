#include "voronaut/benchmarks/suite/suite_paths.h"

#include <gtest/gtest.h>

#include "voronaut/benchmarks/suite/suite_config.h"

namespace voronaut {
namespace {

const char* const kSuite =
    "suite: s\n"
    "scenarios:\n"
    "  - {name: open, world: {}, bounds: [[-1, -1], [6, 6]], start: [0, 0], goal: [5, 5]}\n"
    "  - {name: wood-0.1, generator: {name: forest, side_m: 6}}\n"
    "vehicles: [quadrotor, {name: ideal, label: slow.one, params: {max_speed_m_s: 1}}]\n"
    "planners: [RRTConnect, {name: RRTConnect, label: RRTConnect.b, params: {range: 0.5}}]\n"
    "range_finder: {rays: 31}\n";

SuiteConfig suite_with(const std::vector<std::string>& settings) {
  ConfigNode root = ConfigNode::parse(kSuite, "folder/s.yaml");
  for (const std::string& setting : settings) root = with_setting(root, setting);
  return read_suite(root, "", PlannerCatalog::built_in());
}

std::string error_with(const std::string& setting) {
  try {
    suite_with({setting});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SuitePaths, ReachSectionsThatAreThereAndThatAreNot) {
  const SuiteConfig suite =
      suite_with({"range_finder.max_range_m=3", "mapping.merge_distance_m=0.7", "seed=5"});
  EXPECT_EQ(suite.flight.range_finder.max_range_m, 3);
  EXPECT_EQ(suite.flight.range_finder.rays, 31) << "what stands beside it stays";
  EXPECT_EQ(suite.flight.mapping.merge_distance_m, 0.7);
  EXPECT_EQ(suite.seed, 5U);
}

TEST(SuitePaths, ReachKeysOverAPreset) {
  const SuiteConfig suite =
      suite_with({"navigation=paper", "navigation.recovery=true",
                  "planners.RRTConnect.b.navigation=paper", "vehicle.navigation.preset=careful"});
  EXPECT_FALSE(suite.flight.navigation.governor);
  EXPECT_TRUE(suite.flight.navigation.recovery);
  EXPECT_FALSE(suite.planners[1].navigation.value().recovery);
  EXPECT_TRUE(suite.vehicles[0].flight.value().navigation.governor);
}

TEST(SuitePaths, ReachEntriesOfListsByNameAlsoIfItHasADot) {
  const SuiteConfig suite = suite_with(
      {"planners.RRTConnect.range=1.5", "planners.RRTConnect.b.range=2",
       "planners.RRTConnect.b.navigation.off_path_m=0.9", "vehicles.slow.one.max_speed_m_s=2",
       "scenarios.wood-0.1.side_m=9", "scenarios.open.goal_tolerance_m=0.5"});
  EXPECT_EQ(suite.planners[0].params.at("range"), "1.5") << "an entry that was a name alone";
  EXPECT_EQ(suite.planners[1].params.at("range"), "2");
  EXPECT_EQ(suite.planners[1].navigation.value().off_path_m, 0.9);
  EXPECT_FALSE(suite.planners[0].navigation);
  EXPECT_EQ(suite.vehicles[1].vehicle.limits.max_speed_m_s, 2);
  EXPECT_NE(suite.vehicles[0].vehicle.limits.max_speed_m_s, 2);
  EXPECT_NE(suite.scenarios[1].definition().find("side_m=9"), std::string::npos);
  EXPECT_EQ(suite.scenarios[0].instantiate(1).goal_tolerance_m, 0.5);
}

TEST(SuitePaths, ReachEveryEntryOfAListAtOnce) {
  const SuiteConfig suite =
      suite_with({"vehicle.max_speed_m_s=0.7", "planner.range=3", "vehicle.range_finder.rays=5"});
  for (const VehicleEntry& vehicle : suite.vehicles) {
    EXPECT_EQ(vehicle.vehicle.limits.max_speed_m_s, 0.7);
    EXPECT_EQ(vehicle.flight.value().range_finder.rays, 5);
  }
  for (const PlannerSpec& planner : suite.planners) EXPECT_EQ(planner.params.at("range"), "3");
  EXPECT_EQ(suite.flight.range_finder.rays, 31);
}

TEST(SuitePaths, ReplaceWholeListsAndEntries) {
  EXPECT_EQ(suite_with({"planners=[PotentialField]"}).planners.front().name, "PotentialField");
  const SuiteConfig suite = suite_with({"planners.RRTConnect=PotentialField"});
  EXPECT_EQ(suite.planners[0].name, "PotentialField");
  EXPECT_EQ(suite.planners.size(), 2U);
}

TEST(SuitePaths, ErrorsNameTheArgumentAndTheNearestKey) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"range_findr.rays=3", "--set range_findr.rays: key 'range_findr': unknown key"},
      {"range_finder.ray=3", "did you mean 'rays'?"},
      {"range_finder.rays=0", "--set range_finder.rays: key 'range_finder.rays': expected"},
      {"planners.RRTConect.range=1",
       "--set planners.RRTConect.range: no 'RRTConect' in planners (allowed: RRTConnect, "
       "RRTConnect.b; did you mean 'RRTConnect'?)"},
      {"planners.RRTConnect.rang=1",
       "--set planners.RRTConnect.rang: key 'planners[0].params.rang'"},
      {"vehicle.max_sped_m_s=1", "did you mean 'max_speed_m_s'?"},
      {"scenarios.wood-0.1.sid_m=1", "did you mean 'side_m'?"},
      {"vehicle=ideal", "--set vehicle: 'vehicle' lacks a key"},
      {"suite.name=x", "--set suite.name: 'suite' has no keys (folder/s.yaml:1)"},
      {"rays", "--set: expected path=value, got 'rays'"},
      {"include=a.yaml", "--set include: 'include' is said in files only"},
      {"rays=", "--set: expected path=value, got 'rays='"},
      {"seed=[", "--set seed"},
  };
  for (const auto& [setting, message] : cases)
    EXPECT_NE(error_with(setting).find(message), std::string::npos)
        << setting << ": " << error_with(setting);
}

TEST(SuitePaths, AValueOfTheCommandLineMeansFilesBesideTheSuite) {
  const std::string error = error_with("scenarios=[{file: there.yaml}]");
  EXPECT_NE(error.find("--set scenarios: key 'scenarios[0].file': no file 'folder/there.yaml'"),
            std::string::npos)
      << error;
}

}  // namespace
}  // namespace voronaut
