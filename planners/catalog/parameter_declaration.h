#pragma once

#include <initializer_list>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <ompl/base/GenericParam.h>

namespace voronaut {

// A parameter that says in one sentence what it is. OMPL's say nothing.
struct ParameterSentence {
  virtual ~ParameterSentence() = default;
  std::string sentence;
};

template <class Value>
struct DescribedParameter : ompl::base::SpecificParam<Value>, ParameterSentence {
  using ompl::base::SpecificParam<Value>::SpecificParam;
};

// Declares every field of a config struct as a parameter of an OMPL planner, under the name it has
// everywhere else, from the struct's one visit list. The struct must outlive the set, so it is a
// member of the planner. A value out of bounds makes setParam() return false and changes nothing.
class ParameterDeclaration {
 public:
  explicit ParameterDeclaration(ompl::base::ParamSet& params) : params_(params) {}

  void number(const std::string& name, double& field, double low, double high,
              const std::string& sentence) {
    declare_bounded(name, field, low, high, sentence);
  }

  void count(const std::string& name, int& field, int low, int high, const std::string& sentence) {
    declare_bounded(name, field, low, high, sentence);
  }

  void flag(const std::string& name, bool& field, const std::string& sentence) {
    declare<bool>(
        name, [&field](bool value) { field = value; }, [&field] { return field; }, "0,1", sentence);
  }

  template <class Enum>
  void choice(const std::string& name, Enum& field,
              std::initializer_list<std::pair<const char*, std::type_identity_t<Enum>>> options,
              const std::string& sentence) {
    const std::vector<std::pair<std::string, Enum>> known(options.begin(), options.end());
    std::string range;
    for (const auto& [text, option] : known) range += (range.empty() ? "" : ",") + text;
    declare<std::string>(
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
        },
        range, sentence);
  }

  // A parameter that is no field.
  template <class Value>
  void declare(const std::string& name,
               const typename ompl::base::SpecificParam<Value>::SetterFn& setter,
               const typename ompl::base::SpecificParam<Value>::GetterFn& getter,
               const std::string& range, const std::string& sentence) {
    const auto parameter = std::make_shared<DescribedParameter<Value>>(name, setter, getter);
    parameter->setRangeSuggestion(range);
    parameter->sentence = sentence;
    params_.add(parameter);
  }

 private:
  template <class Number>
  void declare_bounded(const std::string& name, Number& field, Number low, Number high,
                       const std::string& sentence) {
    std::ostringstream range;
    range << low << ":" << high;
    declare<Number>(
        name,
        [&field, low, high](Number value) {
          if (!(value >= low && value <= high)) throw std::invalid_argument("out of bounds");
          field = value;
        },
        [&field] { return field; }, range.str(), sentence);
  }

  ompl::base::ParamSet& params_;
};

}  // namespace voronaut
