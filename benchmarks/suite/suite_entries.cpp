#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include <ompl/base/Planner.h>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/suite/entry_keys.h"
#include "voronaut/benchmarks/suite/footprint_entry.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/label.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

// What a library says about a value, said at the place where the user wrote it.
template <class Work>
auto at(const ConfigNode& node, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw node.error(error.what());
  }
}

std::string known_name(const ConfigNode& node, const std::string& kind,
                       const std::vector<std::string>& known) {
  const std::string name = node.text();
  for (const std::string& each : known)
    if (each == name) return name;
  throw node.error("no " + kind + " " + in_quotes(name) + allowed_names(name, known));
}

// An entry is a name alone or a map with `name` and more.
ConfigNode name_node(const ConfigNode& entry) {
  return entry.is_map() ? entry.child("name") : entry;
}

template <class... Configs>
void read_params(const ConfigNode& entry, std::string_view key, std::variant<Configs...>& config) {
  if (const auto node = entry.find(key))
    std::visit([&](auto& chosen) { read_into(*node, chosen); }, config);
}

std::vector<std::string> names_of(const PlannerCatalog& planners) {
  std::vector<std::string> names;
  for (const PlannerEntry* each : planners.entries()) names.push_back(each->name);
  return names;
}

// Flags of OMPL's parameters are 0 and 1; YAML's are true and false.
std::string parameter_text(const ConfigNode& value) {
  const std::string text = value.text();
  if (text == "true") return "1";
  return text == "false" ? "0" : text;
}

// OMPL's getName() where it is another than the class's, which is the catalogue's.
const std::map<std::string, std::string> kNamesInOmpl = {{"APS", "AnytimePathShortening"},
                                                         {"RRT#", "RRTsharp"},
                                                         {"kABITstar", "ABITstar"},
                                                         {"kBITstar", "BITstar"}};

std::string planner_name(const ConfigNode& node, const PlannerCatalog& planners) {
  const auto of_ompl = kNamesInOmpl.find(node.text());
  if (of_ompl != kNamesInOmpl.end() && planners.find(of_ompl->first) == nullptr)
    throw node.error("no planner " + in_quotes(of_ompl->first) +
                     ": OMPL's planner of this name is '" + of_ompl->second +
                     "' here, as its class");
  return known_name(node, "planner", names_of(planners));
}

void read_own_label(const ConfigNode& entry, std::string& label) {
  const auto node = entry.is_map() ? entry.find("label") : std::nullopt;
  if (!node) return;
  label = read_label(*node);
}

void read_own_flight(const ConfigNode& entry, const FlightConfig& flight, VehicleEntry& read) {
  const auto sections = key_names<FlightConfig>();
  const bool any = std::any_of(sections.begin(), sections.end(),
                               [&](const std::string& key) { return entry.find(key).has_value(); });
  if (any) read_present_keys(entry, keys_of(read.flight.emplace(flight)));
}

// A planner is made, and given parameters, in a process of its own: it may throw, abort or hang.
constexpr ProcessLimits kTryLimits{.memory_mb = 4096, .cpu_s = 10, .wall_s = 10};

// Why a planner cannot be made or does not take one of the parameters, empty if all is well.
std::string try_planner(const PlannerEntry& entry,
                        const std::map<std::string, std::string>& params) {
  const auto work = [&]() -> std::string {
    PlanningProblem problem({.bounds_world = {Vec2(-1, -1), Vec2(1, 1)}});
    const auto planner = entry.make(problem.space_information());
    if (!planner) return "planner '" + entry.name + "' cannot be made: its factory gives none";
    try {
      set_parameters(*planner, entry.name, params);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  const ChildReport report = run_in_child(work, kTryLimits);
  if (report.end == ChildReport::End::finished) return report.output;
  return "planner '" + entry.name +
         "' does not survive this value: " + end_in_words(report, kTryLimits);
}

// Throws at the value that the planner does not take. A planner that cannot even be made becomes
// the outcome of its own trials, not the end of the run.
void require_parameters(const ConfigNode& entry, const PlannerEntry& planner,
                        const PlannerSpec& spec) {
  if (spec.params.empty() || !try_planner(planner, {}).empty()) return;
  const std::string why = try_planner(planner, spec.params);
  if (why.empty()) return;
  const ConfigNode params = entry.child("params");
  for (const std::string& key : params.keys())
    if (const std::string its = try_planner(planner, {{key, spec.params.at(key)}}); !its.empty())
      throw params.child(key).error(its);
  throw params.error(why);
}

}  // namespace

VehicleEntry read_vehicle(const ConfigNode& entry, const FlightConfig& flight) {
  if (entry.is_map()) entry.allow_only(key_names<VehicleEntryKeys>());
  VehicleEntry read;
  read.vehicle = find_vehicle(known_name(name_node(entry), "vehicle", vehicle_names()));
  read_own_label(entry, read.vehicle.name);
  read.regulator_name = read.vehicle.regulator;
  std::optional<ConfigNode> regulator_node;
  if (entry.is_map()) {
    if (const auto params = entry.find("params")) read_into(*params, read.vehicle);
    if (const auto footprint = entry.find("footprint")) read_footprint(*footprint, entry, read);
    read_params(entry, "model", read.vehicle.model);
    read_own_flight(entry, flight, read);
    regulator_node = entry.find("regulator");
  }
  if (regulator_node) {
    if (regulator_node->is_map()) regulator_node->allow_only(key_names<RegulatorEntryKeys>());
    read.regulator_name = known_name(name_node(*regulator_node), "regulator", regulator_names());
  }
  read.regulator = find_regulator(read.regulator_name);
  if (regulator_node && regulator_node->is_map())
    read_params(*regulator_node, "params", read.regulator);
  if (const std::string problem = clearance_problem(read.vehicle); !problem.empty())
    throw entry.error(problem);
  at(entry, [&] { make_model(read.vehicle.model); });
  at(regulator_node.value_or(entry), [&] { stopping_law(read.regulator, read.vehicle); });
  return read;
}

PlannerSpec read_planner(const ConfigNode& entry, const PlannerCatalog& planners,
                         const NavigationConfig& navigation) {
  if (entry.is_map()) entry.allow_only(key_names<PlannerEntryKeys>());
  PlannerSpec spec;
  spec.name = planner_name(name_node(entry), planners);
  spec.label = read_label(name_node(entry));
  read_own_label(entry, spec.label);
  if (const auto own = entry.is_map() ? entry.find("navigation") : std::nullopt)
    read_into(*own, spec.navigation.emplace(navigation));
  if (const auto params = entry.is_map() ? entry.find("params") : std::nullopt)
    for (const std::string& key : params->keys())
      spec.params[key] = parameter_text(params->child(key));
  require_parameters(entry, *planners.find(spec.name), spec);
  return spec;
}

AcceptanceCriterion read_criterion(const ConfigNode& entry, const SuiteConfig& suite) {
  AcceptanceCriterion criterion;
  read_into(entry, criterion);
  const auto require_known = [&](const char* key, const auto& items, const auto& name_of) {
    std::vector<std::string> names;
    for (const auto& item : items)
      if (std::find(names.begin(), names.end(), name_of(item)) == names.end())
        names.push_back(name_of(item));
    if (const auto node = entry.find(key)) known_name(*node, key, names);
  };
  require_known("group", suite.scenarios, [](const ScenarioSpec& s) { return s.group(); });
  require_known("vehicle", suite.vehicles, [](const VehicleEntry& v) { return v.vehicle.name; });
  require_known("planner", suite.planners, [](const PlannerSpec& p) { return p.label; });
  require_known("speed_beside", suite.planners, [](const PlannerSpec& p) { return p.label; });
  return criterion;
}

}  // namespace voronaut
