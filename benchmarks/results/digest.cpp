#include "voronaut/benchmarks/results/digest.h"

#include <cmath>
#include <cstdint>
#include <sstream>
#include <type_traits>

#include "voronaut/benchmarks/results/sha256.h"
#include "voronaut/environments/config/config_node.h"

namespace voronaut {

std::string deterministic_text(const RunRecord& record) {
  std::string text;
  record.visit([&text](const char* name, const auto& value, ColumnKind kind) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if (kind != ColumnKind::deterministic) return;
    text.append(name).append("=");
    if constexpr (std::is_same_v<Value, Outcome>) {
      text += to_string(value);
    } else if constexpr (std::is_same_v<Value, std::int64_t>) {
      text += std::to_string(value);
    } else if constexpr (std::is_same_v<Value, double>) {
      if (!std::isnan(value)) text += number_text(value);
    } else {
      text += value;
    }
    text += "\n";
  });
  return text;
}

std::string difference_text(const RunRecord& stored, const RunRecord& flown) {
  std::istringstream old_lines(deterministic_text(stored));
  std::istringstream new_lines(deterministic_text(flown));
  std::string text;
  for (std::string a, b; std::getline(old_lines, a) && std::getline(new_lines, b);) {
    if (a == b) continue;
    text += (text.empty() ? "" : "; ") + a + ", now " + b.substr(b.find('=') + 1);
  }
  return text;
}

std::string digest(const std::vector<RunRecord>& records) {
  std::string text;
  for (const RunRecord& record : records) text += deterministic_text(record) + "\n";
  return sha256_hex(text);
}

}  // namespace voronaut
