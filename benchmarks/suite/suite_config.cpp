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

DataLocation data_location(const ConfigNode& root, const std::string& data_argument) {
  DataLocation data = DataLocation::find(data_argument);
  const auto named = root.find("data");
  if (data.folder.empty() && named && !named->text().empty())
    data = {named->beside(named->text()), "key 'data'"};
  return data;
}

void read_contents(const ConfigNode& root, const std::string& data_argument,
                   const PlannerCatalog& planners, SuiteConfig& suite) {
  const DataLocation data = data_location(root, data_argument);
  suite.vehicles = read_list<VehicleEntry>(
      root.child("vehicles"),
      [&](const ConfigNode& entry) {
        return std::vector<VehicleEntry>{read_vehicle(entry, suite.flight)};
      },
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
  double clearance_m = 0;
  for (const VehicleEntry& entry : suite.vehicles)
    clearance_m = std::max(clearance_m, entry.vehicle.planning_clearance_m);
  for (ScenarioSpec& scenario : suite.scenarios) scenario = scenario.admitting(clearance_m);
}

// What planners of their own navigation have on vehicles of their own flight.
void read_navigation_of_vehicles(const ConfigNode& root, SuiteConfig& suite) {
  const std::vector<ConfigNode> entries = root.child("planners").items();
  for (VehicleEntry& vehicle : suite.vehicles) {
    if (!vehicle.flight) continue;
    for (std::size_t i = 0; i < suite.planners.size(); ++i) {
      if (!suite.planners[i].navigation) continue;
      NavigationConfig own = vehicle.flight->navigation;
      read_into(entries[i].child("navigation"), own);
      vehicle.navigation.emplace(suite.planners[i].label, own);
    }
  }
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

std::optional<ConfigNode> navigation_in(const ConfigNode& entry) {
  return entry.is_map() ? entry.find("navigation") : std::nullopt;
}

// Where a navigation key of a planner is said, by itself or by a preset: with it, with the vehicle,
// for all, or nowhere and then at its entry.
ConfigNode place_of_key(const ConfigNode& root, const ConfigNode& planner,
                        const ConfigNode& vehicle, const char* key) {
  for (const auto& section :
       {navigation_in(planner), navigation_in(vehicle), root.find("navigation")}) {
    if (!section) continue;
    if (section->is_scalar()) return *section;
    for (const std::string_view said : {std::string_view(key), kPresetKey})
      if (const auto node = section->find(said)) return *node;
  }
  return planner;
}

// Holds what the planners are flown with against what one of the vehicles can do.
void require_able(const ConfigNode& root, const SuiteConfig& suite, std::size_t which) {
  const VehicleEntry& vehicle = suite.vehicles[which];
  const std::string who = "vehicle " + in_quotes(vehicle.vehicle.name);
  const double period_s = vehicle.flight.value_or(suite.flight).loop.vehicle_period_s;
  const std::string no_stop = why_no_stop(vehicle, period_s);
  const bool looks_anywhere = mobility_of(vehicle.vehicle).moves_sideways;
  const ConfigNode vehicle_entry = root.child("vehicles").items()[which];
  const std::vector<ConfigNode> entries = root.child("planners").items();
  for (std::size_t i = 0; i < suite.planners.size(); ++i) {
    const NavigationConfig navigation = flight_of(suite, vehicle, suite.planners[i]).navigation;
    if (navigation.governor && !no_stop.empty())
      throw place_of_key(root, entries[i], vehicle_entry, "governor")
          .error("no governor for " + who + ": " + no_stop +
                 " (allowed: navigation.governor false)");
    if (navigation.yaw_policy != YawReference::path && !looks_anywhere)
      throw place_of_key(root, entries[i], vehicle_entry, "yaw_policy")
          .error("navigation.yaw_policy 'fixed' is not for " + who +
                 ", which looks where it drives (allowed: path)");
  }
}

}  // namespace

SuiteConfig read_suite(const ConfigNode& with_sweep, const std::string& data_argument,
                       const PlannerCatalog& planners) {
  SuiteConfig suite;
  const auto [root, axes] = without_sweep(with_sweep);
  suite.sweep = axes;
  read_into(root, suite);
  suite.name = read_name(root.child("suite"));
  read_contents(root, data_argument, planners, suite);
  read_navigation_of_vehicles(root, suite);
  require_footprints(root, suite);
  if (suite.kind == TrialKind::flown)
    for (std::size_t i = 0; i < suite.vehicles.size(); ++i) require_able(root, suite, i);
  if (const auto acceptance = root.find("acceptance"))
    for (const ConfigNode& entry : acceptance->items())
      suite.acceptance.push_back(read_criterion(entry, suite));
  return suite;
}

FlightConfig flight_of(const SuiteConfig& suite, const VehicleEntry& vehicle,
                       const PlannerSpec& planner) {
  FlightConfig flight = vehicle.flight.value_or(suite.flight);
  const auto own = vehicle.navigation.find(planner.label);
  if (own != vehicle.navigation.end()) {
    flight.navigation = own->second;
  } else if (planner.navigation) {
    flight.navigation = *planner.navigation;
  }
  return flight;
}

void keep_planners(SuiteConfig& suite, const std::vector<std::string>& labels) {
  std::map<std::string, std::string> base_of;
  for (const SweepAxis& axis : suite.sweep)
    if (axis.column == "planner")
      for (const SweptEntry& entry : axis.entries) base_of[entry.label] = entry.base;
  std::vector<std::string> known;
  for (const PlannerSpec& planner : suite.planners) known.push_back(planner.label);
  for (const auto& [label, base] : base_of)
    if (std::find(known.begin(), known.end(), base) == known.end()) known.push_back(base);
  for (const std::string& label : labels) {
    if (std::find(known.begin(), known.end(), label) == known.end())
      throw std::invalid_argument("no planner " + in_quotes(label) + " in suite '" + suite.name +
                                  "'" + allowed_names(label, known));
  }
  std::erase_if(suite.planners, [&](const PlannerSpec& planner) {
    return std::none_of(labels.begin(), labels.end(), [&](const std::string& label) {
      return label == planner.label || label == base_of[planner.label];
    });
  });
}

}  // namespace voronaut
