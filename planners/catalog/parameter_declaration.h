#pragma once

#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <ompl/base/GenericParam.h>

namespace voronaut {

// Declares every field of a config struct as a parameter of an OMPL planner, under the name it has
// everywhere else, from the struct's one visit list. The struct must outlive the set, so it is a
// member of the planner. A value out of bounds makes setParam() return false and changes nothing.
class ParameterDeclaration {
 public:
  explicit ParameterDeclaration(ompl::base::ParamSet& params) : params_(params) {}

  void number(const std::string& name, double& field, double low, double high) {
    declare_bounded(name, field, low, high);
  }

  void count(const std::string& name, int& field, int low, int high) {
    declare_bounded(name, field, low, high);
  }

  void flag(const std::string& name, bool& field) {
    params_.declareParam<bool>(
        name, [&field](bool value) { field = value; }, [&field] { return field; });
    params_[name].setRangeSuggestion("0,1");
  }

  void text(const std::string& name, std::string& field) {
    params_.declareParam<std::string>(
        name, [&field](const std::string& value) { field = value; }, [&field] { return field; });
  }

  template <class Enum>
  void choice(const std::string& name, Enum& field,
              std::initializer_list<std::pair<const char*, std::type_identity_t<Enum>>> options) {
    const std::vector<std::pair<std::string, Enum>> known(options.begin(), options.end());
    params_.declareParam<std::string>(
        name,
        [&field, known](const std::string& value) {
          for (const auto& [text, option] : known) {
            if (text == value) {
              field = option;
              return;
            }
          }
          throw std::invalid_argument("not one of the options");
        },
        [&field, known] {
          for (const auto& [text, option] : known)
            if (option == field) return text;
          return std::string{};
        });
    std::string range;
    for (const auto& [text, option] : known) range += (range.empty() ? "" : ",") + text;
    params_[name].setRangeSuggestion(range);
  }

 private:
  template <class Number>
  void declare_bounded(const std::string& name, Number& field, Number low, Number high) {
    params_.declareParam<Number>(
        name,
        [&field, low, high](Number value) {
          if (!(value >= low && value <= high)) throw std::invalid_argument("out of bounds");
          field = value;
        },
        [&field] { return field; });
    std::ostringstream range;
    range << low << ":" << high;
    params_[name].setRangeSuggestion(range.str());
  }

  ompl::base::ParamSet& params_;
};

}  // namespace voronaut
