#include "voronaut/benchmarks/tuning/search_space.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/random.h"

namespace voronaut {

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw std::invalid_argument("--over: " + in_quotes(text) + ": " + why);
}

double bound(const std::string& text, const std::string& all) {
  const auto value = parse_number(text);
  if (!value) refuse(all, "expected key=LOW:HIGH or key=LOW:HIGH:log");
  return *value;
}

const KeyFact& fact_of(const SearchKey& key, const std::string& text,
                       const std::vector<KeyFact>& declared) {
  std::vector<std::string> names;
  for (const KeyFact& fact : declared) {
    const bool number =
        fact.kind == KeyFact::Kind::number || fact.kind == KeyFact::Kind::whole_number;
    if (number && fact.key == key.key) return fact;
    if (number) names.push_back(fact.key);
  }
  refuse(text,
         "no number " + in_quotes(key.key) + " of this planner" + allowed_names(key.key, names));
}

// So that a label and a file say the value that is flown.
std::string value_text(const SearchKey& key, double part) {
  double value = key.logarithmic ? key.low * std::pow(key.high / key.low, part)
                                 : key.low + part * (key.high - key.low);
  if (key.whole) return number_text(std::clamp(std::round(value), key.low, key.high));
  constexpr int kDigits = 4;
  if (value != 0) {
    const double unit = std::pow(10.0, kDigits - 1 - std::floor(std::log10(std::abs(value))));
    value = std::clamp(std::round(value * unit) / unit, key.low, key.high);
  }
  return number_text(value);
}

}  // namespace

SearchKey search_key(const std::string& text, const std::vector<KeyFact>& declared) {
  SearchKey key;
  const std::size_t equals = text.find('=');
  key.key = text.substr(0, equals);
  std::string rest = equals == std::string::npos ? "" : text.substr(equals + 1);
  if (rest.ends_with(":log")) {
    key.logarithmic = true;
    rest.resize(rest.size() - 4);
  }
  const std::size_t colon = rest.find(':');
  key.low = bound(rest.substr(0, colon), text);
  key.high = bound(colon == std::string::npos ? "" : rest.substr(colon + 1), text);
  if (!(key.low < key.high)) refuse(text, "expected LOW below HIGH");
  if (key.logarithmic && key.low <= 0) refuse(text, "log needs LOW above 0");
  const KeyFact& fact = fact_of(key, text, declared);
  if (key.low < fact.lo || key.high > fact.hi)
    refuse(text, "expected bounds within " + number_text(fact.lo) + ":" + number_text(fact.hi));
  key.whole = fact.kind == KeyFact::Kind::whole_number;
  return key;
}

std::vector<std::vector<std::string>> points_in(const std::vector<SearchKey>& keys,
                                                std::size_t count, std::uint64_t seed) {
  std::vector<std::vector<std::string>> points(count);
  for (const SearchKey& key : keys) {
    Random random(derive_seed(seed, {"tuning", key.key}, count));
    std::vector<std::size_t> strata(count);
    std::iota(strata.begin(), strata.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(strata[i - 1], strata[random.below(i)]);
    for (std::size_t i = 0; i < count; ++i) {
      const double part =
          (static_cast<double>(strata[i]) + random.uniform()) / static_cast<double>(count);
      points[i].push_back(value_text(key, part));
    }
  }
  return points;
}

}  // namespace voronaut
