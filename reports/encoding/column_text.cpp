#include "voronaut/reports/encoding/column_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace voronaut {

std::string column_text(double value) {
  if (std::isnan(value)) {
    return {};
  }
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

}  // namespace voronaut
