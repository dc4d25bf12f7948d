#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/environments/config/key_facts.h"

// The values that a tuning may give to keys of a planner.
namespace voronaut {

struct SearchKey {
  std::string key;  // of the planner's entry, as --set has it after planners.NAME.
  double low = 0;
  double high = 1;
  bool logarithmic = false;
  bool whole = false;
};

// "range=0.1:5:log" held against what the planner declares: numbers within its bounds. Throws
// std::invalid_argument.
SearchKey search_key(const std::string& text, const std::vector<KeyFact>& declared);

// So many points, each a value for each key as text: of every key each of `count` equally wide
// strata has one value (latin hypercube, McKay, Beckman and Conover, Technometrics 21, 1979,
// doi:10.2307/1268522). The same seed gives the same points. O(count * keys).
std::vector<std::vector<std::string>> points_in(const std::vector<SearchKey>& keys,
                                                std::size_t count, std::uint64_t seed);

}  // namespace voronaut
