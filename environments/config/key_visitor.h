#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace voronaut {

template <class Enum>
using ChoiceList = std::initializer_list<std::pair<std::string_view, Enum>>;

// What goes through the keys of a Config struct: reads them, writes them, describes them. A Config
// names each of its keys once, in a visit list:
//
//   template <class Visitor>
//   void visit(Visitor& v) {
//     v.number("max_range_m", max_range_m, 0.01, 100, "How far a beam sees");
//     v.count("rays", rays, 1, 1000, "Beams of a scan");
//     v.flag("clockwise", clockwise, "Which way they turn");
//     v.text("label", label, "What reports call it");
//     v.choice("cut", cut, {{"plane", Cut::plane}, {"columns", Cut::columns}}, "What is taken");
//     v.section("loop", loop, "Clocks and verdicts");     // a Config inside
//     v.form("start", "[x, y]", "Where it starts");       // read by its owner, described here
//   }
//
// Before all others may stand
//     v.presets(*this, {{"careful", {}}, {"hasty", hasty()}}, "What the other keys are");
// named values of all keys, the defaults first. A file says `preset: hasty` among the keys, which
// then hold over it, or the name alone instead of the keys.
//
// Bounds are inclusive. The default is the member's value; one outside the bounds stands for none.
// The unit is the end of the key (unit_of_key). The sentence has no full stop. visit() is a
// template because dynamics/ and planners/ have Configs and do not see this folder; what is done
// with the keys goes through this one class, so each list is compiled once.
class KeyVisitor {
 public:
  virtual ~KeyVisitor() = default;

  virtual void number(std::string_view key, double& value, double lo, double hi,
                      std::string_view sentence) = 0;
  virtual void flag(std::string_view key, bool& value, std::string_view sentence) = 0;
  virtual void text(std::string_view key, std::string& value, std::string_view sentence) = 0;
  // `shape` is "file", "text" or nested lists as error lines write them: "[[x, y, r], ...]".
  virtual void form(std::string_view key, std::string_view shape, std::string_view sentence) = 0;

  template <class Count>
  void count(std::string_view key, Count& value, std::type_identity_t<std::int64_t> lo,
             std::type_identity_t<std::int64_t> hi, std::string_view sentence) {
    auto wide = static_cast<std::int64_t>(value);
    whole_number(key, wide, lo, hi, sentence);
    value = static_cast<Count>(wide);
  }

  template <class Enum>
  void choice(std::string_view key, Enum& value, ChoiceList<std::type_identity_t<Enum>> options,
              std::string_view sentence) {
    std::vector<std::string> names;
    std::size_t chosen = options.size();
    for (const auto& [name, option] : options) {
      if (option == value) chosen = names.size();
      names.emplace_back(name);
    }
    one_of(key, names, chosen, sentence);
    if (chosen < names.size()) value = options.begin()[chosen].second;
  }

  template <class Config>
  void presets(
      Config& config,
      std::initializer_list<std::pair<std::string_view, std::type_identity_t<Config>>> named,
      std::string_view sentence) {
    std::vector<std::string> names;
    for (const auto& [name, preset] : named) names.emplace_back(name);
    std::size_t chosen = names.size();
    one_preset_of(names, chosen, sentence);
    if (chosen < names.size()) config = named.begin()[chosen].second;
  }

  template <class Config>
  void section(std::string_view key, Config& config, std::string_view sentence) {
    nested(
        key, [&config](KeyVisitor& v) { config.visit(v); }, sentence);
  }

  // Which of these groups of keys is given decides `value`; keys of two groups cannot stand
  // together. A visit list then names the keys of a group if all_groups() or it is the group of
  // the value.
  template <class Enum>
  void alternatives(
      Enum& value,
      std::initializer_list<std::pair<std::type_identity_t<Enum>, std::vector<std::string>>>
          groups) {
    std::vector<std::vector<std::string>> keys;
    std::size_t chosen = 0;
    for (const auto& [option, names] : groups) {
      if (option == value) chosen = keys.size();
      keys.push_back(names);
    }
    one_group_of(keys, chosen);
    value = groups.begin()[chosen].first;
  }
  virtual bool all_groups() const { return true; }

 protected:
  virtual void whole_number(std::string_view key, std::int64_t& value, std::int64_t lo,
                            std::int64_t hi, std::string_view sentence) = 0;
  // `chosen` is names.size() if the value is none of them.
  virtual void one_of(std::string_view key, const std::vector<std::string>& names,
                      std::size_t& chosen, std::string_view sentence) = 0;
  virtual void nested(std::string_view key, const std::function<void(KeyVisitor&)>& keys,
                      std::string_view sentence) = 0;
  // `chosen` is names.size() and stays so if none is given.
  virtual void one_preset_of(const std::vector<std::string>&, std::size_t&, std::string_view) {}
  virtual void one_group_of(const std::vector<std::vector<std::string>>&, std::size_t&) {}
};

// The key by which a map of keys names a preset.
inline constexpr std::string_view kPresetKey = "preset";

// A visit list as a value. The Config must outlive it.
using VisitKeys = std::function<void(KeyVisitor&)>;

template <class Config>
VisitKeys keys_of(Config& config) {
  return [&config](KeyVisitor& v) { config.visit(v); };
}

}  // namespace voronaut
