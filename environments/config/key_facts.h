#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/key_visitor.h"

// What a visit list says about its keys, as data: for the schema and the page of all keys.
namespace voronaut {

struct KeyFact {
  enum class Kind { number, whole_number, flag, text, choice, section, form };

  std::string key;
  Kind kind = Kind::text;
  double lo = 0, hi = 0;             // numbers, whole ones too: inclusive
  std::vector<std::string> choices;  // of a choice; of a section its presets
  std::string shape;                 // of a form
  std::string default_text;          // as YAML writes it; empty: none
  std::string sentence;
  std::vector<KeyFact> keys;  // of a section
  int group = -1;             // keys of two groups >= 0 cannot stand together in one section

  bool operator==(const KeyFact&) const = default;
};

// In the order of the list.
std::vector<KeyFact> key_facts(const VisitKeys& keys);

template <class Config>
std::vector<KeyFact> key_facts(Config config) {
  return key_facts(keys_of(config));
}

// "number from 0.1 to 10", "one of a, b", "[x, y]".
std::string allowed_text(const KeyFact& fact);

// "m/s^2" of "max_acceleration_m_s2"; empty where the name has none. The one place that knows how
// names say their units: products in the order of the name, after "1" and "per" a division.
std::string unit_of_key(std::string_view key);

}  // namespace voronaut
