#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "voronaut/planners/catalog/catalog.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

constexpr const char* kPreset = "preset";

// Levenshtein's edit distance, one row at a time.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string nearest(const std::string& name, const std::vector<std::string>& known) {
  const auto closer = [&](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  };
  return *std::min_element(known.begin(), known.end(), closer);
}

std::string unknown_parameter(const ob::Planner& planner, const std::string& name) {
  std::vector<std::string> known;
  planner.params().getParamNames(known);
  std::string message = "planner '" + planner.getName() + "' has no parameter '" + name + "'";
  if (known.empty()) return message + "; it has none";
  message += "; did you mean '" + nearest(name, known) + "'? It has:";
  for (const std::string& each : known) message += " " + each;
  return message;
}

// OMPL reads numbers as a prefix ("1.5x" is 1.5): the whole text must be one.
bool is_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

bool is_numeric(const ob::GenericParam& param) {
  return dynamic_cast<const ob::SpecificParam<double>*>(&param) ||
         dynamic_cast<const ob::SpecificParam<float>*>(&param) ||
         dynamic_cast<const ob::SpecificParam<int>*>(&param) ||
         dynamic_cast<const ob::SpecificParam<unsigned int>*>(&param) ||
         dynamic_cast<const ob::SpecificParam<std::size_t>*>(&param);
}

// OMPL takes any word for a flag.
bool is_flag(const std::string& text) {
  return text == "0" || text == "1" || text == "false" || text == "true";
}

bool try_set(ob::GenericParam& param, const std::string& value) {
  if (is_numeric(param) && !is_number(value)) return false;
  if (dynamic_cast<const ob::SpecificParam<bool>*>(&param) && !is_flag(value)) return false;
  try {
    return param.setValue(value);
  } catch (const std::out_of_range&) {
    return false;
  }
}

void set_one(ob::Planner& planner, const std::string& name, const std::string& value) {
  if (!planner.params().hasParam(name))
    throw std::invalid_argument(unknown_parameter(planner, name));
  ob::GenericParam& param = planner.params()[name];
  if (try_set(param, value)) return;
  std::string message =
      "planner '" + planner.getName() + "': parameter '" + name + "' cannot be '" + value + "'";
  if (!param.getRangeSuggestion().empty()) message += "; allowed: " + param.getRangeSuggestion();
  throw std::invalid_argument(message);
}

}  // namespace

void set_parameters(ob::Planner& planner, const std::map<std::string, std::string>& values) {
  if (const auto preset = values.find(kPreset); preset != values.end())
    set_one(planner, kPreset, preset->second);
  for (const auto& [name, value] : values)
    if (name != kPreset) set_one(planner, name, value);
}

}  // namespace voronaut
