#pragma once

#include <string>
#include <utility>
#include <vector>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/key_visitor.h"

// From YAML into a Config struct and from it to text, by its visit list (key_visitor.h).
namespace voronaut {

// Overwrites the members whose keys are there; the others keep their values. Keys of the map that
// the list does not name, `also_allowed` apart, are refused before any value is looked at. Throws
// ConfigError.
void read_keys(const ConfigNode& node, const VisitKeys& keys,
               const std::vector<std::string>& also_allowed = {});
// The same without a look at other keys.
void read_present_keys(const ConfigNode& node, const VisitKeys& keys);

// The keys in the order of the list.
std::vector<std::string> key_names(const VisitKeys& keys);

using ConfigEntries = std::vector<std::pair<std::string, std::string>>;

// (key, value) in the order of the list: numbers as the shortest decimal that reads back as the
// same, keys of a section as "section.key". Forms are left out.
ConfigEntries key_entries(const VisitKeys& keys);

// "key=value;key=value;": what is hashed and printed. Unambiguous: '\', '=' and ';' inside a text
// are preceded by '\'.
std::string canonical_text(const ConfigEntries& entries);

template <class Config>
void read_into(const ConfigNode& node, Config& config,
               const std::vector<std::string>& also_allowed = {}) {
  read_keys(node, keys_of(config), also_allowed);
}

template <class Config>
std::vector<std::string> key_names() {
  Config config;
  return key_names(keys_of(config));
}

template <class Config>
ConfigEntries config_entries(Config config) {
  return key_entries(keys_of(config));
}

template <class Config>
requires requires(Config config, KeyVisitor& visitor) { config.visit(visitor); }
std::string canonical_text(const Config& config) { return canonical_text(config_entries(config)); }

}  // namespace voronaut
