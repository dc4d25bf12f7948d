#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <ompl/util/Console.h>
#include <ompl/util/Exception.h>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/catalog/parameter_range.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

constexpr const char* kRange = "range";
constexpr const char* kNeighbors = "max_nearest_neighbors";
// A preset sets all others; the range of OMPL's LazyPRM takes the number of neighbours back.
constexpr std::array kFirst{"preset", kRange};

std::string unknown_parameter(const ob::Planner& planner, const std::string& name) {
  std::vector<std::string> known;
  planner.params().getParamNames(known);
  std::string message = " has no parameter '" + name + "'";
  if (known.empty()) return message + "; it has none";
  const auto meant = nearest_name(name, known);
  message += meant ? "; did you mean '" + *meant + "'? It has:" : "; it has:";
  for (const std::string& each : known) message += " " + each;
  return message;
}

// What OMPL complains about as long as this lives, instead of printing it: the list of planners of
// AnytimePathShortening does no more than that about a name, a parameter or a value it cannot read.
class Complaints : ompl::msg::OutputHandler {
 public:
  Complaints() : printer_(ompl::msg::getOutputHandler()), level_printed_(ompl::msg::getLogLevel()) {
    ompl::msg::useOutputHandler(this);
    ompl::msg::setLogLevel(ompl::msg::LOG_WARN);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  ~Complaints() override {
    ompl::msg::setLogLevel(level_printed_);
    ompl::msg::useOutputHandler(printer_);
  }

  const std::string& first() const { return first_; }  // empty if there was none

 private:
  void log(const std::string& text, ompl::msg::LogLevel level, const char*, int) override {
    // Other warnings are general remarks, as BITstar's when it is made.
    const bool refused = level >= ompl::msg::LOG_ERROR || text.starts_with("Invalid value format");
    if (refused && first_.empty()) first_ = text;
  }

  ompl::msg::OutputHandler* printer_;
  ompl::msg::LogLevel level_printed_;
  std::string first_;
};

// Why the parameter does not take the value, empty if it does.
std::string refusal_of(ob::GenericParam& param, const std::string& value) {
  const ParameterRange range(param);
  const std::string allowed = range.allowed().empty() ? "" : "; allowed: " + range.allowed();
  if (!range.allows(value)) return allowed;
  Complaints complaints;
  try {
    if (!param.setValue(value)) return allowed;
  } catch (const std::out_of_range&) {
    return allowed;
  } catch (const ompl::Exception& error) {
    return std::string("; OMPL: ") + error.what();
  }
  if (range.kind == ParameterRange::Kind::flag && param.getValue() != value)
    return "; OMPL leaves it at '" + param.getValue() + "'";
  if (range.kind == ParameterRange::Kind::text && !complaints.first().empty())
    return "; OMPL: " + complaints.first();
  return "";
}

void set_one(ob::Planner& planner, const std::string& name, const std::string& value) {
  if (!planner.params().hasParam(name))
    throw std::invalid_argument(unknown_parameter(planner, name));
  const std::string refusal = refusal_of(planner.params()[name], value);
  if (!refusal.empty())
    throw std::invalid_argument(": parameter '" + name + "' cannot be '" + value + "'" + refusal);
}

// LazyPRM looks for neighbours within its range as it is when their number is set, and that is 0
// unless somebody says otherwise: it would connect nothing.
void require_range_for_neighbors(const ob::Planner& planner,
                                 const std::map<std::string, std::string>& values) {
  if (values.count(kNeighbors) == 0 || !planner.params().hasParam(kRange)) return;
  if (planner.params().getParam(kRange)->getValue() == "0")
    throw std::invalid_argument(std::string(": parameter '") + kNeighbors + "' wants a '" + kRange +
                                "' above 0 beside it");
}

}  // namespace

void set_parameters(ob::Planner& planner, const std::string& catalogue_name,
                    const std::map<std::string, std::string>& values) {
  const auto set_if_given = [&](const char* name) {
    if (const auto given = values.find(name); given != values.end())
      set_one(planner, name, given->second);
  };
  try {
    for (const char* name : kFirst) set_if_given(name);
    for (const auto& [name, value] : values)
      if (std::find(kFirst.begin(), kFirst.end(), name) == kFirst.end())
        set_one(planner, name, value);
    require_range_for_neighbors(planner, values);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("planner '" + catalogue_name + "'" + error.what());
  }
}

}  // namespace voronaut
