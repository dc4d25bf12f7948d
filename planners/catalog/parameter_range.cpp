#include "voronaut/planners/catalog/parameter_range.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string_view>

namespace voronaut {

namespace ob = ompl::base;

namespace {

// Where OMPL 1.5.2 suggests less than makes sense, or nothing where only a fraction makes sense, or
// a value that ends the process. 1024 threads are more than any machine has that runs a trial.
struct JudgedRange {
  std::string_view name;
  std::string_view suggested;
  std::string_view allowed;
};
constexpr std::array kJudged{
    JudgedRange{"degree", "2:20", "2:1000"},
    JudgedRange{"min_degree", "2:20", "2:1000"},
    JudgedRange{"max_degree", "2:20", "2:1000"},
    JudgedRange{"dense_delta_fraction", "0.0:0.0001:0.1", "0:1"},
    JudgedRange{"epsilon", "0.:.01:10.", "0:10000"},
    JudgedRange{"epsilon", "0.:.1:10.", "0:10000"},
    JudgedRange{"max_dist_near", "0.:0.1:10.", "0:10000"},
    JudgedRange{"max_failures", "100:10:3000", "1:1000000"},  // SPARStwo's own default is 5000
    JudgedRange{"max_hybrid_paths", "0:1:50", "0:1000"},
    JudgedRange{"max_nearest_neighbors", "8:1000", "1:1000"},
    JudgedRange{"min_valid_path_fraction", "", "0:1"},
    JudgedRange{"num_planners", "0:64", "1:1024"},  // of none, setup() asks the first for its name
    JudgedRange{"num_threads", "0:64", "0:1024"},
    JudgedRange{"thread_count", "1:64", "1:1024"},
    JudgedRange{"num_samples", "10:10:1000000", "1:1000000"},
    JudgedRange{"number_sampling_attempts", "10:10:100000", "1:100000"},
    JudgedRange{"range", ".1:.1:100", "0.001:10000"},  // SST's; of 0 it makes steps of 0
    JudgedRange{"rewire_factor", "1.0:0.01:2.0", "1:100"},
    JudgedRange{"rewire_factor", "1.0:0.01:3.0", "1:100"},
    JudgedRange{"samples_per_batch", "1:1:1000", "1:1000000"},
    JudgedRange{"stretch_factor", "1.1:0.1:3.0", "1:1000"},
};

std::string_view judged(std::string_view name, std::string_view suggested) {
  for (const JudgedRange& each : kJudged)
    if (each.name == name && each.suggested == suggested) return each.allowed;
  return suggested;
}

template <class... Numbers>
bool is_one_of(const ob::GenericParam& param) {
  return (... || (dynamic_cast<const ob::SpecificParam<Numbers>*>(&param) != nullptr));
}

ParameterRange::Kind kind_of(const ob::GenericParam& param) {
  if (is_one_of<bool>(param)) return ParameterRange::Kind::flag;
  if (is_one_of<double, float, long double>(param)) return ParameterRange::Kind::number;
  if (is_one_of<int, long, long long, unsigned, unsigned long, unsigned long long>(param))
    return ParameterRange::Kind::whole_number;
  return ParameterRange::Kind::text;
}

// The whole text: OMPL would read "1.5x" as 1.5.
template <class Number>
std::optional<Number> read(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

template <class Number>
void narrow_to(ParameterRange& range) {
  range.low = static_cast<double>(std::numeric_limits<Number>::min());
  range.high = static_cast<double>(std::numeric_limits<Number>::max());
}

std::string in_words(double value) {
  std::ostringstream text;
  text.precision(15);  // 1000000 as such, and 0.1 too
  text << value;
  return text.str();
}

}  // namespace

ParameterRange::ParameterRange(const ob::GenericParam& param) : kind(kind_of(param)) {
  if (is_one_of<int>(param)) narrow_to<int>(*this);
  if (is_one_of<unsigned>(param)) narrow_to<unsigned>(*this);
  if (is_one_of<long, long long>(param)) narrow_to<std::int64_t>(*this);
  if (is_one_of<unsigned long, unsigned long long>(param)) narrow_to<std::uint64_t>(*this);
  const std::string_view declared = judged(param.getName(), param.getRangeSuggestion());
  if (kind == Kind::flag) {
    options = {"0", "1"};
  } else if (declared.find(',') != std::string_view::npos) {
    options = split(declared, ',');
  } else if (kind != Kind::text) {
    const std::vector<std::string> parts = split(declared, ':');
    if (parts.size() < 2) return;
    if (const auto lowest = read<double>(parts.front())) low = std::max(low, *lowest);
    if (const auto highest = read<double>(parts.back())) high = std::min(high, *highest);
  }
}

bool ParameterRange::allows(const std::string& value) const {
  if (!options.empty()) return std::find(options.begin(), options.end(), value) != options.end();
  if (kind == Kind::text) return true;
  if (kind == Kind::whole_number && !read<std::int64_t>(value) && !read<std::uint64_t>(value))
    return false;
  const auto number = read<double>(value);
  return number && std::isfinite(*number) && *number >= low && *number <= high;
}

std::string ParameterRange::allowed() const {
  if (!options.empty()) {
    std::string text;
    for (const std::string& option : options) text += (text.empty() ? "" : ",") + option;
    return text;
  }
  if (kind == Kind::text) return "";
  const std::string numbers = kind == Kind::whole_number ? "whole numbers" : "numbers";
  const bool bounded_below = std::isfinite(low);
  const bool bounded_above = std::isfinite(high);
  if (bounded_below && bounded_above)
    return numbers + " from " + in_words(low) + " to " + in_words(high);
  if (bounded_below) return numbers + " from " + in_words(low);
  return bounded_above ? numbers + " up to " + in_words(high) : numbers;
}

}  // namespace voronaut
