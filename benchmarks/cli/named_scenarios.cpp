#include "voronaut/benchmarks/cli/named_scenarios.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/dynamics/catalog.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/data_sets.h"
#include "voronaut/environments/formats/foreign_formats.h"
#include "voronaut/environments/generators/world_generators.h"

namespace voronaut {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<NamedScenarios> shipped(const std::string& name, const std::string& kind) {
  for (const ShippedFile& file : shipped_files(kind))
    if (file.name == name)
      return NamedScenarios{ConfigNode::read_file(file.file.string()), kind == "suites"};
  return std::nullopt;
}

std::optional<NamedScenarios> made_or_published(const std::string& name) {
  if (has(WorldGenerator::names(), name))
    return NamedScenarios{
        ConfigNode::parse("name: " + name + "\ngenerator: {name: " + name + "}\n", name), false};
  if (has(data_set_names(), name))
    return NamedScenarios{ConfigNode::parse("dataset: " + name + "\n", name), false};
  return std::nullopt;
}

// What a name stands for that has no worlds.
void refuse_other_things(const std::string& name, const std::vector<std::string>& planners) {
  const std::pair<const char*, std::vector<std::string>> others[] = {
      {"planner", planners}, {"vehicle", vehicle_names()}, {"regulator", regulator_names()}};
  for (const auto& [kind, names] : others)
    if (has(names, name))
      throw std::invalid_argument(in_quotes(name) + " is a " + kind +
                                  " and has no worlds (`voronaut list " + kind + "s " + name +
                                  "` prints its parameters)");
  if (has(foreign_format_names(), name))
    throw std::invalid_argument(in_quotes(name) +
                                " is a format: name a file of it (`voronaut show FILE --format " +
                                name + "`)");
}

std::vector<std::string> every_name() {
  std::vector<std::string> names;
  for (const char* kind : {"suites", "scenarios"})
    for (const ShippedFile& file : shipped_files(kind)) names.push_back(file.name);
  for (const auto& more : {WorldGenerator::names(), data_set_names()})
    for (const std::string& name : more)
      if (!has(names, name)) names.push_back(name);
  return names;
}

}  // namespace

bool is_suite(const ConfigNode& root) {
  const auto keys = {"suite", "planners", "vehicles", "include"};
  return std::any_of(keys.begin(), keys.end(),
                     [&](const char* key) { return root.find(key).has_value(); });
}

NamedScenarios find_scenarios(const std::string& argument, bool suites_first,
                              const std::vector<std::string>& planners) {
  std::error_code ignored;
  if (std::filesystem::exists(argument, ignored)) {
    const ConfigNode root = ConfigNode::read_file(argument);
    return {root, is_suite(root)};
  }
  const auto suite = shipped(argument, "suites");
  if (suites_first && suite) return *suite;
  if (const auto scenario = shipped(argument, "scenarios")) return *scenario;
  if (const auto other = made_or_published(argument)) return *other;
  if (suite) return *suite;
  refuse_other_things(argument, planners);
  if (!std::filesystem::path(argument).extension().empty())
    throw std::invalid_argument(argument + ": no such file");
  throw std::invalid_argument("no suite or scenario " + in_quotes(argument) +
                              allowed_names(argument, every_name()));
}

}  // namespace voronaut
