#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace voronaut {

// Where a name stands among those seen so far, at their end if it is new; -1 for an empty one.
// O(names).
inline int index_of(std::vector<std::string>& names, const std::string& name) {
  if (name.empty()) return -1;
  const auto known = std::find(names.begin(), names.end(), name) - names.begin();
  if (known == std::ssize(names)) names.push_back(name);
  return static_cast<int>(known);
}

}  // namespace voronaut
