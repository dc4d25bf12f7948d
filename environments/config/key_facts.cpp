#include "voronaut/environments/config/key_facts.h"

#include <array>
#include <cmath>
#include <utility>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {
namespace {

using Kind = KeyFact::Kind;

class FactCollector : public KeyVisitor {
 public:
  std::vector<KeyFact> facts;

  // What is not counted unless it is given has no default.
  void drop_defaults_of_other_groups() {
    for (KeyFact& fact : facts)
      if (fact.group != -1 && fact.group != by_default_) fact.default_text.clear();
  }

  void number(std::string_view key, double& value, double lo, double hi,
              std::string_view sentence) override {
    KeyFact& fact = add(key, Kind::number, sentence);
    fact.lo = lo;
    fact.hi = hi;
    if (value >= lo && value <= hi) fact.default_text = number_text(value);
  }
  void flag(std::string_view key, bool& value, std::string_view sentence) override {
    add(key, Kind::flag, sentence).default_text = value ? "true" : "false";
  }
  void text(std::string_view key, std::string& value, std::string_view sentence) override {
    add(key, Kind::text, sentence).default_text = value;
  }
  void form(std::string_view key, std::string_view shape, std::string_view sentence) override {
    add(key, Kind::form, sentence).shape = shape;
  }

 private:
  void whole_number(std::string_view key, std::int64_t& value, std::int64_t lo, std::int64_t hi,
                    std::string_view sentence) override {
    KeyFact& fact = add(key, Kind::whole_number, sentence);
    fact.lo = static_cast<double>(lo);
    fact.hi = static_cast<double>(hi);
    if (value >= lo && value <= hi) fact.default_text = std::to_string(value);
  }
  void one_of(std::string_view key, const std::vector<std::string>& names, std::size_t& chosen,
              std::string_view sentence) override {
    KeyFact& fact = add(key, Kind::choice, sentence);
    fact.choices = names;
    if (chosen < names.size()) fact.default_text = names[chosen];
  }
  void nested(std::string_view key, const VisitKeys& keys, std::string_view sentence) override {
    FactCollector inner;
    keys(inner);
    inner.drop_defaults_of_other_groups();
    KeyFact& fact = add(key, Kind::section, sentence);
    fact.choices = std::move(inner.presets_);
    fact.keys = std::move(inner.facts);
  }
  void one_preset_of(const std::vector<std::string>& names, std::size_t&,
                     std::string_view sentence) override {
    presets_ = names;
    KeyFact& fact = add(kPresetKey, Kind::choice, sentence);
    fact.choices = names;
    fact.default_text = names.front();
  }
  void one_group_of(const std::vector<std::vector<std::string>>& groups,
                    std::size_t& chosen) override {
    groups_ = groups;
    by_default_ = static_cast<int>(chosen);
  }

  KeyFact& add(std::string_view key, Kind kind, std::string_view sentence) {
    KeyFact fact;
    fact.key = key;
    fact.kind = kind;
    fact.sentence = sentence;
    for (std::size_t group = 0; group < groups_.size(); ++group)
      for (const std::string& one : groups_[group])
        if (one == key) fact.group = static_cast<int>(group);
    facts.push_back(std::move(fact));
    return facts.back();
  }

  std::vector<std::string> presets_;
  std::vector<std::vector<std::string>> groups_;
  int by_default_ = -1;
};

// Endings of names, longest first where one ends with another.
constexpr std::array<std::pair<std::string_view, std::string_view>, 24> kUnits{{
    {"_per_speed_s", "s"}, {"_s_per_m", "s/m"},  {"_per_m2", "1/m^2"}, {"_1_s2", "1/s^2"},
    {"_1_s", "1/s"},       {"_1_m", "1/m"},      {"_rad_s", "rad/s"},  {"_N_m_s2", "N m s^2"},
    {"_m_s2", "m/s^2"},    {"_N_m_s", "N m s"},  {"_N_m_A", "N m/A"},  {"_N_m", "N m"},
    {"_N_s2", "N s^2"},    {"_kg_m2", "kg m^2"}, {"_V_s", "V s"},      {"_m_s", "m/s"},
    {"_ohm", "ohm"},       {"_rad", "rad"},      {"_mb", "MB"},        {"_hz", "Hz"},
    {"_kg", "kg"},         {"_V", "V"},          {"_s", "s"},          {"_m", "m"},
}};

std::string range_text(const KeyFact& fact) {
  const std::string what = fact.kind == Kind::number ? "number" : "whole number";
  const bool bounded_above = std::isfinite(fact.hi) && fact.hi < 1e18;
  if (std::isfinite(fact.lo) && bounded_above)
    return what + " from " + number_text(fact.lo) + " to " + number_text(fact.hi);
  if (std::isfinite(fact.lo)) return what + " from " + number_text(fact.lo);
  return bounded_above ? what + " up to " + number_text(fact.hi) : what;
}

}  // namespace

std::vector<KeyFact> key_facts(const VisitKeys& keys) {
  FactCollector collector;
  keys(collector);
  collector.drop_defaults_of_other_groups();
  return std::move(collector.facts);
}

std::string allowed_text(const KeyFact& fact) {
  switch (fact.kind) {
    case Kind::number:
    case Kind::whole_number:
      return range_text(fact);
    case Kind::flag:
      return "true or false";
    case Kind::choice:
      return "one of " + join_names(fact.choices);
    case Kind::form:
      return fact.shape;
    case Kind::section:
      return fact.choices.empty() ? "section" : "section, or one of " + join_names(fact.choices);
    case Kind::text:
      break;
  }
  return "text";
}

std::string unit_of_key(std::string_view key) {
  for (const auto& [ending, unit] : kUnits)
    if (key.ends_with(ending)) return std::string(unit);
  return "";
}

}  // namespace voronaut
