#include "voronaut/benchmarks/suite/suite_paths.h"

#include <algorithm>
#include <filesystem>

#include "voronaut/benchmarks/suite/entry_keys.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/environments/config/key_facts.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/scenario_files/scenario_keys.h"

namespace voronaut {

namespace {

// "a.b.c" is "a", then "b.c".
std::string head_of(const std::string& path) { return path.substr(0, path.find('.')); }

std::string tail_of(const std::string& path) {
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? "" : path.substr(dot + 1);
}

ConfigNode with_keys(const ConfigNode& map, const std::string& path, const ConfigNode& value) {
  const std::string key = head_of(path);
  const std::string below = tail_of(path);
  if (key.empty()) throw value.error("expected a path of keys with dots between them");
  if (below.empty()) return map.with(key, value);
  auto section = map.find(key);
  if (section && section->is_scalar() && has_presets(key)) section = section->under(kPresetKey);
  if (section && !section->is_map())
    throw value.error(in_quotes(key) + " has no keys (" + section->place() + ")");
  if (section) return map.with(key, with_keys(*section, below, value));
  return map.with(key,
                  with_keys(value.under(head_of(below)).without(head_of(below)), below, value));
}

template <class Keys>
bool is_key_of(const std::string& key) {
  const auto names = key_names<Keys>();
  return std::find(names.begin(), names.end(), key) != names.end();
}

ConfigNode as_map(const ConfigNode& entry) { return entry.is_map() ? entry : entry.under("name"); }

ConfigNode with_regulator(const ConfigNode& vehicle, const std::string& key,
                          const ConfigNode& value) {
  const auto regulator = vehicle.find("regulator");
  if (key.empty() || !regulator) return with_keys(vehicle, "regulator." + key, value);
  const bool own = is_key_of<RegulatorEntryKeys>(head_of(key));
  return vehicle.with("regulator",
                      with_keys(as_map(*regulator), own ? key : "params." + key, value));
}

bool is_scenario_key(const std::string& key) {
  return is_key_of<TaskConfig>(key) || is_key_of<GeneratorKeys>(key);
}

// Throws `place.error()` if no entry of the list is called so.
std::string named_entry(const ConfigNode& list, const std::string& rest, const ConfigNode& place) {
  std::string longest;
  std::vector<std::string> names;
  for (const ConfigNode& entry : list.items()) {
    const std::string name = entry_name(entry);
    names.push_back(name);
    if ((rest == name || rest.starts_with(name + ".")) && name.size() > longest.size())
      longest = name;
  }
  if (longest.empty())
    throw place.error("no " + in_quotes(head_of(rest)) + " in " + list.path() +
                      allowed_names(head_of(rest), names));
  return longest;
}

}  // namespace

bool has_presets(const std::string& section) {
  const auto facts = key_facts(FlightConfig{});
  return std::any_of(facts.begin(), facts.end(), [&](const KeyFact& fact) {
    return fact.key == section && fact.kind == KeyFact::Kind::section && !fact.choices.empty();
  });
}

const std::vector<SuiteList>& suite_lists() {
  static const std::vector<SuiteList> lists = {
      {"planners", "planner"}, {"vehicles", "vehicle"}, {"scenarios", "scenario"}};
  return lists;
}

std::string entry_name(const ConfigNode& entry) {
  if (entry.is_scalar()) return entry.text();
  if (!entry.is_map()) return {};
  for (const char* key : {"label", "name", "dataset"})
    if (const auto node = entry.find(key); node && node->is_scalar()) return node->text();
  if (const auto generator = entry.find("generator"))
    if (generator->is_map() && generator->find("name")) return entry_name(*generator);
  for (const char* key : {"file", "world_file"})
    if (const auto node = entry.find(key); node && node->is_scalar())
      return std::filesystem::path(node->text()).stem().string();
  return {};
}

EntryPath entry_path(const ConfigNode& root, const std::string& path, const ConfigNode& place) {
  const std::string head = head_of(path);
  const std::string rest = tail_of(path);
  for (const SuiteList& list : suite_lists()) {
    if (head == list.each) {
      if (rest.empty()) throw place.error(in_quotes(list.each) + " lacks a key: of every entry");
      return {&list, "", rest};
    }
    if (head != list.key) continue;
    if (rest.empty()) return {&list, "", ""};
    const std::string name = named_entry(root.child(list.key), rest, place);
    return {&list, name, rest == name ? "" : rest.substr(name.size() + 1)};
  }
  return {nullptr, "", path};
}

ConfigNode with_entry_value(const SuiteList& list, const ConfigNode& entry, const std::string& key,
                            const ConfigNode& value) {
  const std::string head = head_of(key);
  if (list.key == "scenarios") {
    const bool drawn = entry.is_map() && entry.find("generator") && !is_scenario_key(head);
    return with_keys(entry, drawn ? "generator." + key : key, value);
  }
  const ConfigNode map = as_map(entry);
  if (list.key == "planners") {
    if (is_key_of<PlannerEntryKeys>(head)) return with_keys(map, key, value);
    const auto params = map.find("params");  // whose names may have dots
    return map.with("params", params ? params->with(key, value) : value.under(key));
  }
  if (head == "regulator" && key != head) return with_regulator(map, tail_of(key), value);
  return with_keys(map, is_key_of<VehicleEntryKeys>(head) ? key : "params." + key, value);
}

ConfigNode with_value_at(const ConfigNode& root, const std::string& path, const ConfigNode& value) {
  if (path.starts_with("sweep.")) {
    std::string axis = tail_of(path);
    const bool zipped = head_of(axis) == "zipped" && axis != "zipped";
    if (zipped) axis = tail_of(axis);
    const auto sweep = root.find("sweep");
    const auto axes = zipped && sweep ? sweep->find("zipped") : sweep;
    const ConfigNode now = axes ? axes->with(axis, value) : value.under(axis);
    if (!zipped) return root.with("sweep", now);
    return root.with("sweep", sweep ? sweep->with("zipped", now) : now.under("zipped"));
  }
  const EntryPath where = entry_path(root, path, value);
  if (where.list == nullptr) return with_keys(root, path, value);
  if (where.key.empty() && where.entry.empty()) return root.with(where.list->key, value);
  const ConfigNode list = root.child(where.list->key);
  std::vector<ConfigNode> entries = list.items();
  for (ConfigNode& entry : entries) {
    if (!where.entry.empty() && entry_name(entry) != where.entry) continue;
    entry = where.key.empty() ? value : with_entry_value(*where.list, entry, where.key, value);
  }
  return root.with(where.list->key, list.with_items(entries));
}

ConfigNode with_setting(const ConfigNode& root, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string path = assignment.substr(0, equals);
  const std::string called = "--set " + path;
  if (equals == std::string::npos || equals == 0 || equals + 1 == assignment.size())
    throw ConfigError("--set", 0, "", "expected path=value, got " + in_quotes(assignment));
  if (head_of(path) == "include")  // whose files are in `root` already
    throw ConfigError(called, 0, "", "'include' is said in files only");
  return with_value_at(root, path, root.value(assignment.substr(equals + 1), called));
}

}  // namespace voronaut
