#include "voronaut/benchmarks/suite/suite_config.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

#include "voronaut/benchmarks/suite/budget_config.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

template <class Config>
void read_section(const ConfigNode& root, std::string_view key, Config& config) {
  if (const auto node = root.find(key)) read_into(*node, config);
}

// A suite's name becomes a folder.
std::string read_name(const ConfigNode& node) {
  const std::string name = node.text();
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  if (name.empty() || name.front() == '.' || !std::all_of(name.begin(), name.end(), plain))
    throw node.error("expected a name of letters, digits, '-', '_' and '.', got " +
                     in_quotes(name));
  return name;
}

// At least one entry; `read` turns one into any number of items; no two items of one name.
template <class Item, class Read, class Name>
std::vector<Item> read_list(const ConfigNode& node, const Read& read, const Name& name_of,
                            const std::string& advice) {
  std::vector<Item> items;
  std::map<std::string, int> lines;
  for (const ConfigNode& entry : node.items()) {
    for (Item& item : read(entry)) {
      const auto [found, is_new] = lines.emplace(name_of(item), entry.line());
      if (!is_new)
        throw entry.error("the name " + in_quotes(found->first) + " is taken (line " +
                          std::to_string(found->second) + "); " + advice);
      items.push_back(std::move(item));
    }
  }
  if (items.empty()) throw node.error("expected at least one entry, got none");
  return items;
}

DataLocation data_location(const ConfigNode& root, const std::string& data_argument) {
  DataLocation data = DataLocation::find(data_argument);
  const auto named = root.find("data");
  if (data.folder.empty() && named) data = {root.beside(named->text()), "key 'data'"};
  return data;
}

void read_contents(const ConfigNode& root, const std::string& data_argument,
                   const PlannerCatalog& planners, SuiteConfig& suite) {
  const DataLocation data = data_location(root, data_argument);
  suite.vehicles = read_list<VehicleEntry>(
      root.child("vehicles"),
      [](const ConfigNode& entry) { return std::vector<VehicleEntry>{read_vehicle(entry)}; },
      [](const VehicleEntry& entry) { return entry.vehicle.name; }, "give this one a label");
  suite.planners = read_list<PlannerSpec>(
      root.child("planners"),
      [&](const ConfigNode& entry) {
        return std::vector<PlannerSpec>{read_planner(entry, planners, suite.navigation)};
      },
      [](const PlannerSpec& planner) { return planner.label; }, "give this one a label");
  suite.scenarios = read_list<ScenarioSpec>(
      root.child("scenarios"), [&](const ConfigNode& entry) { return read_scenarios(entry, data); },
      [](const ScenarioSpec& scenario) { return scenario.name(); }, "give this one another name");
}

// A wheeled vehicle looks where it drives, and no stop is proved for it along a course that leads
// anywhere else.
void require_drivable(const ConfigNode& root, const SuiteConfig& suite) {
  const auto wheeled =
      std::find_if(suite.vehicles.begin(), suite.vehicles.end(),
                   [](const VehicleEntry& entry) { return is_wheeled(entry.vehicle); });
  if (wheeled == suite.vehicles.end() || suite.kind == TrialKind::known) return;
  const std::string who = "vehicle " + in_quotes(wheeled->vehicle.name);
  const std::vector<ConfigNode> entries = root.child("planners").items();
  for (std::size_t i = 0; i < suite.planners.size(); ++i) {
    const auto own = entries[i].is_map() ? entries[i].find("navigation") : std::nullopt;
    const auto shared = root.find("navigation");
    const auto said_at = [&](const char* key) {
      for (const auto& section : {own, shared})
        if (const auto node = section ? section->find(key) : std::nullopt) return *node;
      return entries[i];
    };
    const NavigationConfig& navigation = suite.planners[i].navigation.value_or(suite.navigation);
    if (navigation.governor)
      throw said_at("governor")
          .error("the governor proves no stop for " + who +
                 ", which cannot move sideways (allowed: false)");
    if (navigation.yaw_policy != YawReference::path)
      throw said_at("yaw_policy")
          .error("navigation.yaw_policy 'fixed' is not for " + who +
                 ", which looks where it drives (allowed: path)");
  }
}

}  // namespace

SuiteConfig read_suite(const ConfigNode& root, const std::string& data_argument,
                       const PlannerCatalog& planners) {
  root.allow_only({"suite", "kind", "seed", "repetitions", "repeat", "data", "scenarios",
                   "vehicles", "planners", "range_finder", "mapping", "navigation", "loop",
                   "budget", "limits", "traces", "claims"});
  SuiteConfig suite;
  suite.name = read_name(root.child("suite"));
  if (const auto kind = root.find("kind"))
    suite.kind = static_cast<TrialKind>(kind->choice({"flown", "known"}));
  if (const auto seed = root.find("seed"))
    suite.seed = static_cast<std::uint64_t>(seed->whole_number(0, kLargest));
  if (const auto repetitions = root.find("repetitions"))
    suite.repetitions = static_cast<int>(repetitions->whole_number(1, 1'000'000));
  if (const auto repeat = root.find("repeat"))
    suite.repeat = repeat->choice({"all", "random"}) == 0 ? Repeat::all : Repeat::random;
  read_section(root, "range_finder", suite.range_finder);
  read_section(root, "mapping", suite.mapping);
  read_section(root, "navigation", suite.navigation);
  read_section(root, "loop", suite.loop);
  if (const auto budget = root.find("budget")) suite.budget = read_budget(*budget);
  read_section(root, "limits", suite.limits);
  if (const auto traces = root.find("traces"))
    suite.traces = static_cast<TraceKeeping>(traces->choice({"all", "failures", "none"}));
  read_contents(root, data_argument, planners, suite);
  require_drivable(root, suite);
  if (const auto claims = root.find("claims"))
    for (const ConfigNode& entry : claims->items())
      suite.claims.push_back(read_claim(entry, suite));
  return suite;
}

void keep_planners(SuiteConfig& suite, const std::vector<std::string>& labels) {
  std::vector<std::string> known;
  for (const PlannerSpec& planner : suite.planners) known.push_back(planner.label);
  for (const std::string& label : labels) {
    if (std::find(known.begin(), known.end(), label) == known.end())
      throw std::invalid_argument("no planner " + in_quotes(label) + " in suite '" + suite.name +
                                  "'" + allowed_names(label, known));
  }
  std::erase_if(suite.planners, [&](const PlannerSpec& planner) {
    return std::find(labels.begin(), labels.end(), planner.label) == labels.end();
  });
}

}  // namespace voronaut
