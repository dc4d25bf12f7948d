#include "voronaut/benchmarks/keys/json_schema.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/tests/benchmarks/keys/schema_validator.h"

namespace voronaut {
namespace {

using Json = nlohmann::ordered_json;

const FileKeys& keys() {
  static const FileKeys all = file_keys(PlannerCatalog::built_in());
  return all;
}

const Json& of_suites() {
  static const Json schema = Json::parse(suite_schema(keys()));
  return schema;
}

std::vector<std::string> shipped_texts(const std::string& kind) {
  const std::filesystem::path folder =
      std::filesystem::path(VORONAUT_SOURCE_DIR) / "benchmarks" / kind;
  std::vector<std::string> texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".yaml") texts.push_back(read_text_file(entry.path()));
  return texts;
}

std::string problem_with(const std::string& replaced, const std::string& by) {
  std::string text =
      "suite: s\n"
      "scenarios: [{name: a, world: {circles: [[2, 2, 0.5]]}, bounds: [[-1, -1], [6, 6]], start: "
      "[0, 0], goal: [5, 5]}, {generator: {name: forest, side_m: 6}}]\n"
      "vehicles: [quadrotor, {name: ideal, label: b, params: {max_speed_m_s: 1}}]\n"
      "planners: [RRTConnect, {name: RRTConnect, label: c, params: {range: 0.5}}]\n"
      "budget: {iterations: 5}\n";
  const std::size_t at = text.find(replaced);
  EXPECT_NE(at, std::string::npos) << replaced;
  text.replace(at, replaced.size(), by);
  return schema_problem(json_of_yaml(text), of_suites());
}

TEST(JsonSchema, TakesEverySuiteThatShips) {
  const auto texts = shipped_texts("suites");
  EXPECT_GT(texts.size(), 20U);
  for (const std::string& text : texts)
    EXPECT_EQ(schema_problem(json_of_yaml(text), of_suites()), "") << text;
}

TEST(JsonSchema, TakesSweepsAndWhatIsIncluded) {
  EXPECT_EQ(problem_with("budget: {iterations: 5}",
                         "sweep: {vehicle.max_speed_m_s: [1, 2], zipped: {loop.goal_hold_s: [1]}, "
                         "planners.c.range: {from: 1, to: 2, steps: 3}}"),
            "");
  EXPECT_EQ(problem_with("label: b", "range_finder: {rays: 90}"), "");
  EXPECT_EQ(problem_with("budget: {iterations: 5}", "navigation: paper"), "");
  EXPECT_EQ(problem_with("params: {range: 0.5}", "navigation: {preset: paper, recovery: true}"),
            "");
  const auto problem_of = [](const std::string& text) {
    return schema_problem(json_of_yaml(text), of_suites());
  };
  EXPECT_EQ(problem_of("include: base.yaml\nsuite: s\n"), "");
  EXPECT_EQ(problem_of("include: [a.yaml, b.yaml]\n"), "");
  EXPECT_NE(problem_of("include: []\n"), "");
}

TEST(JsonSchema, TakesEveryScenarioThatShips) {
  const Json schema = Json::parse(scenario_schema(keys()));
  const auto texts = shipped_texts("scenarios");
  EXPECT_GT(texts.size(), 5U);
  for (const std::string& text : texts)
    EXPECT_EQ(schema_problem(json_of_yaml(text), schema), "") << text;
}

TEST(JsonSchema, RefusesWhatTheReadersRefuse) {
  EXPECT_EQ(problem_with("suite: s", "suite: s"), "");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"suite: s", "siute: s"},
      {"suite: s\n", ""},
      {"circles", "circels"},
      {"[2, 2, 0.5]", "[2, 2]"},
      {"goal: [5, 5]", "goal: 5"},
      {"side_m: 6", "sied_m: 6"},
      {"side_m: 6", "side_m: 0"},
      {"name: forest", "name: forst"},
      {"[quadrotor", "[quadrotr"},
      {"max_speed_m_s", "clearance_min_m"},
      {"max_speed_m_s: 1", "max_speed_m_s: 1000"},
      {"params: {max_speed_m_s: 1}", "model: {mass_kg: 1}"},
      {"params: {max_speed_m_s: 1}", "regulator: {name: ideal, params: {poles: custom}}"},
      {"range: 0.5", "rang: 0.5"},
      {"range: 0.5", "range: far"},
      {"params: {range: 0.5}", "navigation: {governer: true}"},
      {"params: {range: 0.5}", "navigation: papre"},
      {"budget: {iterations: 5}", "navigation: {preset: papre}"},
      {"budget: {iterations: 5}", "range_finder: paper"},
      {"budget: {iterations: 5}", "budget: {iterations: 5, wall_clock_s: 1}"},
      {"budget: {iterations: 5}", "budget: {iterations: 0}"},
      {"budget: {iterations: 5}", "mapping: {merge_m: 1}"},
      {"budget: {iterations: 5}", "acceptance: [{crash_share: 1}]"},
      {"budget: {iterations: 5}", "sweep: {vehicle.max_speed_m_s: []}"},
      {"budget: {iterations: 5}", "sweep: {vehicle.max_speed_m_s: {from: 1, to: 2}}"},
      {"budget: {iterations: 5}", "sweep: {zipped: {vehicle.max_speed_m_s: 3}}"},
      {"label: b", "range_finder: {rays: none}"},
  };
  for (const auto& [replaced, by] : cases) EXPECT_NE(problem_with(replaced, by), "") << by;
}

void expect_sentences(const std::vector<KeyFact>& facts) {
  for (const KeyFact& fact : facts) {
    EXPECT_FALSE(fact.sentence.empty()) << fact.key;
    EXPECT_FALSE(fact.sentence.ends_with('.')) << fact.key;
    expect_sentences(fact.keys);
  }
}

TEST(FileKeys, SayOfEachKeyWhatItIs) {
  const FileKeys& all = keys();
  for (const auto* facts :
       {&all.suite, &all.vehicle, &all.regulator, &all.planner, &all.criterion, &all.task,
        &all.file, &all.world, &all.world_file, &all.generator, &all.data_set, &all.foreign_options,
        &all.query_file, &all.query_selection})
    expect_sentences(*facts);
  for (const auto* named :
       {&all.vehicle_params, &all.vehicle_models, &all.regulators, &all.generators})
    for (const NamedKeys& each : *named) expect_sentences(each.keys);
  for (const NamedKeys& planner : all.planners)
    if (planner.name == "VoronoiRoadmap" || planner.name == "ReactiveVoronoi" ||
        planner.name == "PotentialField")
      expect_sentences(planner.keys);
}

}  // namespace
}  // namespace voronaut
