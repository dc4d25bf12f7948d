#include "voronaut/benchmarks/suite/suite_config.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/scenario_files/scenario_reader.h"

namespace voronaut {

namespace {

// A suite's name becomes a folder.
std::string read_name(const ConfigNode& node) {
  const std::string name = node.text();
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  constexpr std::size_t kLongest = 100;
  if (name.empty() || name.size() > kLongest || name.front() == '.' ||
      !std::all_of(name.begin(), name.end(), plain))
    throw node.error("expected a name of at most " + std::to_string(kLongest) +
                     " letters, digits, '-', '_' and '.', got " +
                     in_quotes(name.substr(0, kLongest)));
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

DataLocation data_location(const ConfigNode& root, const std::string& data_argument,
                           const std::string& named) {
  DataLocation data = DataLocation::find(data_argument);
  if (data.folder.empty() && !named.empty()) data = {root.beside(named), "key 'data'"};
  return data;
}

void read_contents(const ConfigNode& root, const std::string& data_argument,
                   const PlannerCatalog& planners, SuiteConfig& suite) {
  const DataLocation data = data_location(root, data_argument, suite.data);
  suite.vehicles = read_list<VehicleEntry>(
      root.child("vehicles"),
      [](const ConfigNode& entry) { return std::vector<VehicleEntry>{read_vehicle(entry)}; },
      [](const VehicleEntry& entry) { return entry.vehicle.name; }, "give this one a label");
  suite.planners = read_list<PlannerSpec>(
      root.child("planners"),
      [&](const ConfigNode& entry) {
        return std::vector<PlannerSpec>{read_planner(entry, planners, suite.flight.navigation)};
      },
      [](const PlannerSpec& planner) { return planner.label; }, "give this one a label");
  suite.scenarios = read_list<ScenarioSpec>(
      root.child("scenarios"), [&](const ConfigNode& entry) { return read_scenarios(entry, data); },
      [](const ScenarioSpec& scenario) { return scenario.name(); }, "give this one another name");
}

// Why the safety governor cannot keep a vehicle from touching, empty if it can.
std::string why_no_stop(const VehicleEntry& entry, double period_s) {
  try {
    motion_response(entry.regulator, entry.vehicle, period_s);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// Where a navigation key of a planner is said: with it, for all, or nowhere and then at its entry.
ConfigNode place_of_key(const ConfigNode& root, const ConfigNode& planner, const char* key) {
  const auto own = planner.is_map() ? planner.find("navigation") : std::nullopt;
  for (const auto& section : {own, root.find("navigation")})
    if (const auto node = section ? section->find(key) : std::nullopt) return *node;
  return planner;
}

// Holds what the planners are flown with against what one of the vehicles can do.
void require_able(const ConfigNode& root, const SuiteConfig& suite, const VehicleEntry& vehicle) {
  const std::string who = "vehicle " + in_quotes(vehicle.vehicle.name);
  const std::string no_stop = why_no_stop(vehicle, suite.flight.loop.vehicle_period_s);
  const bool looks_anywhere = mobility_of(vehicle.vehicle).moves_sideways;
  const std::vector<ConfigNode> entries = root.child("planners").items();
  for (std::size_t i = 0; i < suite.planners.size(); ++i) {
    const NavigationConfig& navigation =
        suite.planners[i].navigation.value_or(suite.flight.navigation);
    if (navigation.governor && !no_stop.empty())
      throw place_of_key(root, entries[i], "governor")
          .error("no governor for " + who + ": " + no_stop + " (allowed: false)");
    if (navigation.yaw_policy != YawReference::path && !looks_anywhere)
      throw place_of_key(root, entries[i], "yaw_policy")
          .error("navigation.yaw_policy 'fixed' is not for " + who +
                 ", which looks where it drives (allowed: path)");
  }
}

}  // namespace

SuiteConfig read_suite(const ConfigNode& root, const std::string& data_argument,
                       const PlannerCatalog& planners) {
  SuiteConfig suite;
  read_into(root, suite);
  suite.name = read_name(root.child("suite"));
  read_contents(root, data_argument, planners, suite);
  if (suite.kind == TrialKind::flown)
    for (const VehicleEntry& vehicle : suite.vehicles) require_able(root, suite, vehicle);
  if (const auto acceptance = root.find("acceptance"))
    for (const ConfigNode& entry : acceptance->items())
      suite.acceptance.push_back(read_criterion(entry, suite));
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
