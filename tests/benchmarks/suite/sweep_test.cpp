#include "voronaut/benchmarks/suite/sweep.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

namespace voronaut {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kBody =
    "suite: s\n"
    "repetitions: 2\n"
    "scenarios:\n"
    "  - {name: wood, group: trees, generator: {name: forest, side_m: 6, density_per_m2: 0.05}}\n"
    "vehicles: [quadrotor, {name: ideal, label: point}]\n"
    "planners: [{name: RRTConnect, navigation: {off_path_m: 0.9}}, PotentialField]\n";

SuiteConfig suite_of(const std::string& sweep) {
  return read_suite(ConfigNode::parse(kBody + sweep, "s.yaml"), "", PlannerCatalog::built_in());
}

std::string error_of(const std::string& sweep) {
  try {
    suite_of(sweep);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<std::string> planner_labels(const SuiteConfig& suite) {
  std::vector<std::string> labels;
  for (const PlannerSpec& planner : suite.planners) labels.push_back(planner.label);
  return labels;
}

std::vector<std::string> vehicle_labels(const SuiteConfig& suite) {
  std::vector<std::string> labels;
  for (const VehicleEntry& vehicle : suite.vehicles) labels.push_back(vehicle.vehicle.name);
  return labels;
}

std::vector<TrialSpec> trials_of(const SuiteConfig& suite) {
  std::vector<TrialSpec> all;
  SuiteTrials trials(suite);
  while (auto planned = trials.next()) all.push_back(std::move(planned->spec));
  EXPECT_EQ(all.size(), trials.total());
  return all;
}

TEST(Sweep, OfAPlannersKeyMakesOnePlannerForEachValueAndLeavesTheOthers) {
  const SuiteConfig suite = suite_of("sweep: {planners.RRTConnect.range: [0.5, 1, 2]}\n");
  EXPECT_THAT(planner_labels(suite), ElementsAre("RRTConnect range=0.5", "RRTConnect range=1",
                                                 "RRTConnect range=2", "PotentialField"));
  EXPECT_EQ(suite.planners[1].params.at("range"), "1");
  EXPECT_EQ(suite.planners[1].name, "RRTConnect");
  EXPECT_EQ(suite.planners[1].navigation.value().off_path_m, 0.9) << "what it had it keeps";
  ASSERT_EQ(suite.sweep.size(), 1U);
  EXPECT_EQ(suite.sweep[0].column, "planner");
  EXPECT_EQ(suite.sweep[0].entries[2].label, "RRTConnect range=2");
  EXPECT_EQ(suite.sweep[0].entries[2].base, "RRTConnect");
}

TEST(Sweep, CrossesItsAxes) {
  const SuiteConfig suite = suite_of(
      "sweep:\n  vehicle.max_speed_m_s: [1, 2]\n"
      "  range_finder.max_range_m: {from: 1, to: 2, steps: 3}\n"
      "  planners.RRTConnect.range: [1, 2]\n");
  EXPECT_EQ(suite.vehicles.size(), 12U);
  EXPECT_EQ(suite.vehicles[1].vehicle.name, "quadrotor max_speed_m_s=1 max_range_m=1.5");
  EXPECT_EQ(suite.vehicles[1].vehicle.limits.max_speed_m_s, 1);
  EXPECT_EQ(suite.vehicles[1].flight.value().range_finder.max_range_m, 1.5);
  EXPECT_EQ(trials_of(suite).size(), 2U * 12 * 3);
}

TEST(Sweep, FliesEachTrialWithTheValuesThatItsNamesSay) {
  const SuiteConfig suite = suite_of(
      "sweep:\n  range_finder.max_range_m: [1, 3]\n"
      "  navigation.stall_timeout_s: [4, 5]\n");
  std::set<std::string> ids;
  for (const TrialSpec& trial : trials_of(suite)) {
    ids.insert(trial.trial_id);
    const bool far = trial.vehicle.name.find("max_range_m=3") != std::string::npos;
    EXPECT_EQ(trial.flight.range_finder.max_range_m, far ? 3 : 1);
    const bool patient = trial.vehicle.name.find("stall_timeout_s=5") != std::string::npos;
    EXPECT_EQ(trial.flight.navigation.stall_timeout_s, patient ? 5 : 4);
    if (trial.planner.label == "RRTConnect")
      EXPECT_EQ(trial.flight.navigation.off_path_m, 0.9) << "its own key over the vehicle's";
    else
      EXPECT_NE(trial.flight.navigation.off_path_m, 0.9);
  }
  EXPECT_EQ(ids.size(), 2U * 8 * 2);
}

TEST(Sweep, OfPlannersAndVehiclesMeetsTheSameWorlds) {
  const SuiteConfig suite =
      suite_of("sweep: {planners.RRTConnect.range: [1, 2], vehicle.max_speed_m_s: [1, 2]}\n");
  std::map<std::int64_t, std::set<std::string>> worlds;
  for (const TrialSpec& trial : trials_of(suite)) worlds[trial.repetition].insert(trial.world_id);
  for (const auto& [repetition, ids] : worlds) EXPECT_EQ(ids.size(), 1U) << repetition;
}

TEST(Sweep, OfScenariosMakesGroupsOfTheirOwn) {
  const SuiteConfig suite = suite_of("sweep: {scenario.density_per_m2: [0.02, 0.1]}\n");
  ASSERT_EQ(suite.scenarios.size(), 2U);
  EXPECT_EQ(suite.scenarios[1].name(), "wood-density_per_m2-0.1");
  EXPECT_EQ(suite.scenarios[1].group(), "trees-density_per_m2-0.1");
  EXPECT_THAT(suite.scenarios[1].definition(), HasSubstr("density_per_m2=0.1;"));
  const auto columns = columns_of(suite.sweep);
  EXPECT_EQ(columns[0].value_of("trees-density_per_m2-0.1", "quadrotor", "RRTConnect"), "0.1");
}

TEST(Sweep, ThatIsZippedGoesInStepAcrossLists) {
  const SuiteConfig suite = suite_of(
      "sweep:\n  zipped:\n    scenario.side_m: [6, 8]\n"
      "    vehicles.point.max_speed_m_s: [1, 2]\n"
      "    vehicles.point.loop.goal_hold_s: [2, 3]\n"
      "    planners.RRTConnect.range: [0.5, 1.5]\n"
      "  vehicles.quadrotor.max_speed_m_s: [1, 3]\n");
  std::map<std::string, int> met;
  for (const TrialSpec& t : trials_of(suite))
    ++met[t.scenario.name + ", " + t.vehicle.name + ", " + t.planner.label];
  EXPECT_EQ(met.size(), 2U * (2 + 1) * (1 + 1)) << "of both speeds of the other, one of its own";
  EXPECT_TRUE(
      met.contains("wood-side_m-8, point max_speed_m_s=2 goal_hold_s=3, RRTConnect range=1.5"));
  EXPECT_TRUE(met.contains("wood-side_m-8, quadrotor max_speed_m_s=1, RRTConnect range=1.5"));
  EXPECT_FALSE(
      met.contains("wood-side_m-8, point max_speed_m_s=1 goal_hold_s=2, RRTConnect range=1.5"));
  EXPECT_FALSE(
      met.contains("wood-side_m-8, point max_speed_m_s=2 goal_hold_s=3, RRTConnect range=0.5"));
}

TEST(Sweep, OfShardsIsTheSweepOfTheWhole) {
  const SuiteConfig suite =
      suite_of("sweep: {zipped: {scenario.side_m: [6, 8], planners.RRTConnect.range: [1, 2]}}\n");
  std::set<std::string> whole;
  for (const TrialSpec& trial : trials_of(suite)) whole.insert(trial.trial_id);
  std::set<std::string> parts;
  for (std::size_t i = 1; i <= 3; ++i) {
    SuiteTrials trials(suite, nullptr, {i, 3});
    while (auto planned = trials.next())
      EXPECT_TRUE(parts.insert(planned->spec.trial_id).second) << "in two shards";
  }
  EXPECT_EQ(parts, whole);
}

TEST(Sweep, RangesHaveBothEndsAndNoNoiseOfArithmetic) {
  const auto values = [](const std::string& range) {
    std::vector<std::string> texts;
    for (const SweptEntry& e :
         suite_of("sweep: {planners.RRTConnect.range: " + range + "}\n").sweep[0].entries)
      texts.push_back(e.value);
    return texts;
  };
  EXPECT_THAT(values("{from: 0.1, to: 0.5, steps: 5}"),
              ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(values("{from: 0.1, to: 10, steps: 3, spacing: logarithmic}"),
              ElementsAre("0.1", "1", "10"));
  EXPECT_THAT(values("{from: 0.1, to: 3, steps: 5, spacing: logarithmic}"),
              ElementsAre("0.1", "0.234", "0.5477", "1.282", "3"));
  EXPECT_THAT(values("{from: 1, to: 2, steps: 4}"), ElementsAre("1", "1.3333", "1.6667", "2"));
  EXPECT_THAT(values("{from: 20, to: 20.5, steps: 3}"), ElementsAre("20", "20.25", "20.5"));
  EXPECT_THAT(values("{from: 2, to: 0, steps: 3}"), ElementsAre("2", "1", "0"));
}

TEST(Sweep, TellsAxesOfOneLastKeyApart) {
  const SuiteConfig suite = suite_of(
      "sweep: {vehicles.point.navigation.off_path_m: [0.5], vehicles.point.params.max_speed_m_s: "
      "[1], vehicles.point.max_speed_m_s: [2]}\n");
  EXPECT_EQ(vehicle_labels(suite)[1],
            "point off_path_m=0.5 params.max_speed_m_s=1 max_speed_m_s=2");
}

TEST(Sweep, ErrorsNameFileLineAndNearestKey) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"sweep: {planners.RRTConect.range: [1]}\n",
       "s.yaml:7: key 'sweep.planners.RRTConect.range': no 'RRTConect' in planners (allowed: "
       "RRTConnect, PotentialField; did you mean 'RRTConnect'?)"},
      {"sweep: {planners.RRTConnect.rang: [1]}\n", "did you mean 'range'?"},
      {"sweep:\n  vehicle.max_speed_m_s:\n    - 1\n    - fast\n",
       "s.yaml:10: key 'vehicles[1].params.max_speed_m_s': expected a number"},
      {"sweep: {range_findr.rays: [3]}\n", "did you mean 'range_finder'?"},
      {"sweep: {range_finder.ray: [3]}\n", "did you mean 'rays'?"},
      {"sweep: {limits.cpu_s: [3]}\n", "a sweep goes over no 'limits'"},
      {"sweep: {range_finder.rays: []}\n", "expected at least one value"},
      {"sweep: {range_finder.rays: [3, 3]}\n", "the value '3' is given twice"},
      {"sweep: {range_finder.rays: 3}\n", "expected a list"},
      {"sweep: {range_finder.rays: {from: 1, to: 3}}\n", "range_finder.rays.steps': missing"},
      {"sweep: {range_finder.rays: {from: 1, to: 3, steps: 2, step: 1}}\n",
       "did you mean 'steps'?"},
      {"sweep: {range_finder.rays: {from: 0, to: 3, steps: 2, spacing: logarithmic}}\n", "above 0"},
      {"sweep: {range_finder: [1, 2]}\n", "expected the path of a key"},
      {"sweep: {planners.RRTConnect: [1, 2]}\n", "expected the path of a key"},
      {"sweep: {planners.RRTConnect.label: [a, b]}\n", "expected the path of a key"},
      {"sweep: {zipped: {vehicle.max_speed_m_s: [1, 2], range_finder.rays: [3]}}\n",
       "has 1 values, 'vehicle.max_speed_m_s' has 2"},
      {"sweep: {range_finder.rays: {from: 1, to: 200, steps: 200}, planner.range: [1], "
       "vehicle.max_speed_m_s: {from: 1, to: 2, steps: 100}}\n",
       "makes more than 10000"},
  };
  for (const auto& [sweep, message] : cases)
    EXPECT_NE(error_of(sweep).find(message), std::string::npos) << sweep << error_of(sweep);
}

TEST(Sweep, KeepsAllThatItMadeOfAPlannerThatIsAskedFor) {
  SuiteConfig suite = suite_of("sweep: {planners.RRTConnect.range: [1, 2]}\n");
  keep_planners(suite, {"RRTConnect"});
  EXPECT_THAT(planner_labels(suite), ElementsAre("RRTConnect range=1", "RRTConnect range=2"));
  keep_planners(suite, {"RRTConnect range=2"});
  EXPECT_THAT(planner_labels(suite), ElementsAre("RRTConnect range=2"));
}

TEST(Sweep, IsInTheConfigurationOnlyWhereThereIsOne) {
  EXPECT_THAT(suite_json(suite_of("sweep: {range_finder.rays: [3, 5]}\n")),
              HasSubstr("\"sweep\": ["));
  const std::string none = suite_json(suite_of(""));
  EXPECT_EQ(none.find("sweep"), std::string::npos);
  EXPECT_EQ(none.find("\"flight\""), std::string::npos);
}

TEST(Sweep, IsInTheDocumentationAsItIsRead) {
  const std::string page = read_text_file(std::string(VORONAUT_SOURCE_DIR) + "/docs/sweeps.md");
  const std::string fence = "```yaml\n";
  const auto begin = page.find(fence) + fence.size();
  const SuiteConfig suite = read_suite(
      ConfigNode::parse(page.substr(begin, page.find("```", begin) - begin), "docs.yaml"), "",
      PlannerCatalog::built_in());
  EXPECT_EQ(suite.vehicles.size(), 5U * 3);
  EXPECT_EQ(suite.planners.size(), 1U + 3);
  const std::string line = "    sweep: {zipped: ";
  const auto zipped = page.find(line) + 4;
  EXPECT_EQ(suite_of(page.substr(zipped, page.find('\n', zipped) - zipped) + "\n").sweep.size(),
            3U);
}

TEST(Sweep, ShipsInASuite) {
  const std::string file = find_suite("sensor-range").string();
  const SuiteConfig suite = read_suite(ConfigNode::read_file(file), "", PlannerCatalog::built_in());
  ASSERT_EQ(suite.sweep.size(), 2U);
  EXPECT_EQ(suite.vehicles.size(), 15U);
}

}  // namespace
}  // namespace voronaut
