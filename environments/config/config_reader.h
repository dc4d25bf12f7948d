#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "voronaut/environments/config/config_node.h"

// What drives the visit list of a Config struct: reading it from YAML and writing it as text. A
// Config names each of its members once, in `template <class Visitor> void visit(Visitor&)`.
namespace voronaut {

template <class Enum>
using ChoiceList = std::initializer_list<std::pair<std::string_view, Enum>>;

class ConfigKeys {
 public:
  std::vector<std::string> names;

  void number(std::string_view key, double&, double, double) { names.emplace_back(key); }
  void count(std::string_view key, int&, int, int) { names.emplace_back(key); }
  void flag(std::string_view key, bool&) { names.emplace_back(key); }
  void text(std::string_view key, std::string&) { names.emplace_back(key); }
  template <class Enum>
  void choice(std::string_view key, Enum&, ChoiceList<std::type_identity_t<Enum>>) {
    names.emplace_back(key);
  }
};

// Overwrites the members whose keys are there; the others keep their defaults.
class ConfigReader {
 public:
  explicit ConfigReader(const ConfigNode& node) : node_(node) {}

  void number(std::string_view key, double& value, double lo, double hi) {
    if (const auto found = node_.find(key)) value = found->number(lo, hi);
  }
  void count(std::string_view key, int& value, int lo, int hi) {
    if (const auto found = node_.find(key)) value = static_cast<int>(found->whole_number(lo, hi));
  }
  void flag(std::string_view key, bool& value) {
    if (const auto found = node_.find(key)) value = found->flag();
  }
  void text(std::string_view key, std::string& value) {
    if (const auto found = node_.find(key)) value = found->text();
  }
  template <class Enum>
  void choice(std::string_view key, Enum& value, ChoiceList<std::type_identity_t<Enum>> options) {
    const auto found = node_.find(key);
    if (!found) return;
    std::vector<std::string> names;
    for (const auto& option : options) names.emplace_back(option.first);
    value = options.begin()[found->choice(names)].second;
  }

 private:
  const ConfigNode& node_;
};

// Reads a map into a Config. Keys of the map that the Config does not name, `also_allowed` apart,
// are refused before any value is looked at.
template <class Config>
void read_into(const ConfigNode& node, Config& config,
               const std::vector<std::string>& also_allowed = {}) {
  ConfigKeys keys;
  config.visit(keys);
  keys.names.insert(keys.names.begin(), also_allowed.begin(), also_allowed.end());
  node.allow_only(keys.names);
  ConfigReader reader(node);
  config.visit(reader);
}

using ConfigEntries = std::vector<std::pair<std::string, std::string>>;

// Every member as text: numbers as the shortest decimal that reads back as the same.
class ConfigWriter {
 public:
  ConfigEntries entries;

  void number(std::string_view key, double& value, double, double) {
    entries.emplace_back(key, number_text(value));
  }
  void count(std::string_view key, int& value, int, int) {
    entries.emplace_back(key, std::to_string(value));
  }
  void flag(std::string_view key, bool& value) {
    entries.emplace_back(key, value ? "true" : "false");
  }
  void text(std::string_view key, std::string& value) { entries.emplace_back(key, value); }
  template <class Enum>
  void choice(std::string_view key, Enum& value, ChoiceList<std::type_identity_t<Enum>> options) {
    for (const auto& [name, option] : options)
      if (option == value) entries.emplace_back(key, name);
  }
};

// (key, value) in the order of the visit list: for manifests and reports.
template <class Config>
ConfigEntries config_entries(Config config) {
  ConfigWriter writer;
  config.visit(writer);
  return std::move(writer.entries);
}

// "key=value;key=value;": what is hashed and printed. Unambiguous: '\', '=' and ';' inside a text
// are preceded by '\'.
std::string canonical_text(const ConfigEntries& entries);

template <class Config>
requires requires(Config config, ConfigWriter writer) { config.visit(writer); }
std::string canonical_text(const Config& config) { return canonical_text(config_entries(config)); }

}  // namespace voronaut
