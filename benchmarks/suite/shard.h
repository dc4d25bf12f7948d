#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voronaut {

// One of `count` parts of a suite. Which one a trial belongs to follows from its id alone: no
// order, no machine and no other trial has a say, and the parts are about equally large.
struct Shard {
  std::size_t number = 1;  // 1 ... count
  std::size_t count = 1;

  static constexpr std::size_t kCountMax = 100'000;

  // "2/8". Throws std::invalid_argument.
  static Shard parse(const std::string& text);

  bool is_whole() const { return count == 1; }
  bool holds(std::string_view trial_id) const;
  std::string text() const;         // "2/8"
  std::string folder_name() const;  // "2-of-8"
};

}  // namespace voronaut
