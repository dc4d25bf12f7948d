#include "voronaut/benchmarks/suite/shard.h"

#include <charconv>
#include <cstdint>
#include <stdexcept>

#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

namespace {

// All of the text as a number; 0 if it is none.
std::size_t count_in(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

Shard Shard::parse(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard{0, 0};
  if (slash != std::string::npos)
    shard = {count_in(std::string_view(text).substr(0, slash)),
             count_in(std::string_view(text).substr(slash + 1))};
  if (shard.number < 1 || shard.number > shard.count || shard.count > kCountMax)
    throw std::invalid_argument("--shard: expected i/n with 1 <= i <= n <= " +
                                std::to_string(kCountMax) + ", got " + in_quotes(text));
  return shard;
}

bool Shard::holds(std::string_view trial_id) const {
  std::uint64_t value = 0;
  const std::string_view digits = trial_id.substr(0, 16);
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value % count == number - 1;
}

std::string Shard::text() const { return std::to_string(number) + "/" + std::to_string(count); }

std::string Shard::folder_name() const {
  return std::to_string(number) + "-of-" + std::to_string(count);
}

}  // namespace voronaut
