#include "voronaut/benchmarks/results/manifest.h"

#include <array>

#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/benchmarks/suite/config_json.h"
#include "voronaut/benchmarks/suite/suite_includes.h"
#include "voronaut/benchmarks/suite/suite_paths.h"
#include "voronaut/benchmarks/trial/sha256.h"
#include "voronaut/environments/scenario/scenario_spec.h"

namespace voronaut {

namespace {

using Json = nlohmann::ordered_json;

Json pairs_json(const std::vector<std::pair<std::string, std::string>>& pairs) {
  Json object = Json::object();
  for (const auto& [key, value] : pairs) object[key] = value;
  return object;
}

template <class... Configs>
Json variant_json(const std::variant<Configs...>& config) {
  return std::visit([](const auto& chosen) { return config_json(chosen); }, config);
}

Json vehicle_json(const VehicleEntry& entry) {
  Json json = {
      {"label", entry.vehicle.name},
      {"params", config_json(entry.vehicle)},
      {"model", variant_json(entry.vehicle.model)},
      {"regulator", {{"name", entry.regulator_name}, {"params", variant_json(entry.regulator)}}}};
  if (entry.flight) json["flight"] = config_json(*entry.flight);
  return json;
}

Json planner_json(const PlannerSpec& planner) {
  Json json = {{"label", planner.label}, {"name", planner.name}, {"params", Json(planner.params)}};
  if (planner.navigation) json["navigation"] = config_json(*planner.navigation);
  return json;
}

template <class Item, class ToJson>
Json list_json(const std::vector<Item>& items, const ToJson& to_json) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(to_json(item));
  return list;
}

Json scenario_json(const ScenarioSpec& scenario) {
  return {{"name", scenario.name()},
          {"group", scenario.group()},
          {"random", scenario.random()},
          {"definition_sha256", sha256_hex(scenario.definition())}};
}

// These decide how many results there are and what is kept of them, or are seen in the scenarios.
constexpr std::array kNotDefining{"repetitions", "repeat", "data", "limits", "traces"};

}  // namespace

nlohmann::ordered_json defining_json(const SuiteConfig& suite) {
  Json json = config_json(suite);
  for (const char* key : kNotDefining) json.erase(key);
  json["scenarios"] = list_json(suite.scenarios, scenario_json);
  json["vehicles"] = list_json(suite.vehicles, vehicle_json);
  json["planners"] = list_json(suite.planners, planner_json);
  return json;
}

namespace {

Json full_json(const SuiteConfig& suite) {
  Json json = defining_json(suite);
  for (std::size_t i = 0; i < suite.scenarios.size(); ++i)
    if (suite.scenarios[i].random())  // short then, and a report can name what a sweep goes over
      json["scenarios"][i]["definition"] = suite.scenarios[i].definition();
  const Json all = config_json(suite);
  for (const char* key : kNotDefining) json[key] = all.at(key);
  if (!suite.sweep.empty()) json["sweep"] = Json::parse(axis_columns_json(columns_of(suite.sweep)));
  return json;
}

Json build_json() {
  const BuildInfo build = build_info();
  return {{"version", build.version},       {"commit", build.commit},
          {"dirty", build.dirty},           {"compiler", build.compiler},
          {"build_type", build.build_type}, {"flags", build.flags},
          {"program_sha256", program_id()}, {"libraries", pairs_json(build.libraries)}};
}

}  // namespace

namespace {

// While a FileSession lives.
ConfigNode root_of(const SuiteSource& source) {
  ConfigNode root = with_includes(ConfigNode::parse(source.text, source.file));
  for (const std::string& setting : source.set) root = with_setting(root, setting);
  return root;
}

}  // namespace

ConfigNode SuiteSource::root() const {
  const FileSession session(files);
  return root_of(*this);
}

SuiteConfig SuiteSource::read(const PlannerCatalog& planners) {
  FileSession session(files);
  SuiteConfig suite = read_suite(root_of(*this), data_argument, planners);
  if (!seed.empty()) suite.seed = std::stoull(seed);
  if (!repetitions.empty()) suite.repetitions = std::stoi(repetitions);
  if (files.empty()) files = session.read();
  return suite;
}

std::string suite_json(const SuiteConfig& suite) { return full_json(suite).dump(2); }

std::string suite_identity(const SuiteConfig& suite) {
  return sha256_hex(defining_json(suite).dump());
}

std::string manifest_json(const SuiteSource& source, const SuiteConfig& suite,
                          const std::vector<std::string>& command, const std::string& started_utc,
                          const std::string& shard) {
  Json manifest = {{"program", build_json()},
                   {"machine", pairs_json(machine_facts())},
                   {"command", command},
                   {"started_utc", started_utc},
                   {"suite_file", source.file},
                   {"suite_text", source.text},
                   {"configuration", full_json(suite)}};
  if (!source.set.empty()) manifest["set"] = source.set;
  if (!shard.empty()) manifest["shard"] = shard;
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace voronaut
