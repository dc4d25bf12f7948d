#include "voronaut/benchmarks/results/suite_differences.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "voronaut/benchmarks/results/manifest.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

using Json = nlohmann::ordered_json;
using Settings = std::map<std::string, std::string>;

// Lists are of items with a name.
std::string name_of(const Json& item) {
  for (const char* key : {"label", "name"})
    if (item.is_object() && item.contains(key)) return item[key].get<std::string>();
  return {};
}

void flatten(const Json& json, const std::string& path, Settings& settings) {
  const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) flatten(value, below(key), settings);
  } else if (json.is_array()) {
    for (const Json& item : json) flatten(item, below(name_of(item)), settings);
  } else {
    settings[path] = json.is_string() ? json.get<std::string>() : json.dump();
  }
}

Settings settings_of(const SuiteConfig& suite) {
  Settings settings;
  flatten(defining_json(suite), "", settings);
  return settings;
}

bool is_below(const std::string& key, const std::string& path) {
  return key == path || key.starts_with(path + ".");
}

// "planners.RRTConnect" of a key in a list's item.
bool item_is_missing(const std::string& key, const Settings& settings) {
  for (const char* list : {"scenarios.", "vehicles.", "planners."}) {
    if (!key.starts_with(list)) continue;
    const std::size_t end = key.find('.', std::string(list).size());
    const std::string item = key.substr(0, end) + ".";
    const auto next = settings.lower_bound(item);
    return next == settings.end() || !next->first.starts_with(item);
  }
  return false;
}

std::string words_of(const std::string& key, const Settings& settings) {
  const auto found = settings.find(key);
  return found == settings.end() ? "nothing" : in_quotes(found->second);
}

}  // namespace

std::vector<std::string> suite_differences(const SuiteConfig& before, const SuiteConfig& now,
                                           const std::vector<std::string>& across) {
  const Settings there = settings_of(before);
  const Settings here = settings_of(now);
  std::set<std::string> keys;
  for (const Settings* settings : {&there, &here})
    for (const auto& [key, value] : *settings) keys.insert(key);
  const auto is_meant = [&](const std::string& key) {
    return std::any_of(across.begin(), across.end(),
                       [&](const std::string& path) { return is_below(key, path); });
  };
  std::vector<std::string> differences;
  for (const std::string& key : keys) {
    if (is_meant(key) || item_is_missing(key, there) || item_is_missing(key, here)) continue;
    const std::string before_words = words_of(key, there);
    const std::string now_words = words_of(key, here);
    if (before_words != now_words)
      differences.push_back(key + ": " + before_words + ", then " + now_words);
  }
  return differences;
}

}  // namespace voronaut
