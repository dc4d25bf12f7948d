#include "voronaut/environments/config/nearest_name.h"

#include <algorithm>
#include <cstddef>

namespace voronaut {
namespace {

constexpr std::size_t kLongestShown = 60;

std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view written,
                                        const std::vector<std::string>& names) {
  std::optional<std::string> nearest;
  std::size_t fewest = 0;
  for (const std::string& name : names) {
    const std::size_t longest = std::max(written.size(), name.size());
    // A difference in length alone needs that many edits: long garbage is not compared.
    if (longest - std::min(written.size(), name.size()) > longest / 3) continue;
    const std::size_t needed = edits(written, name);
    if (needed > longest / 3 || (nearest && needed >= fewest)) continue;
    nearest = name;
    fewest = needed;
  }
  return nearest;
}

std::string join_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

std::string allowed_names(std::string_view written, const std::vector<std::string>& names) {
  std::string text = " (allowed: " + join_names(names);
  if (const auto meant = nearest_name(written, names)) text += "; did you mean '" + *meant + "'?";
  return text + ")";
}

std::string in_quotes(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string shown = "'";
  for (const char c : text.substr(0, kLongestShown)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == '\n') {
      shown += "\\n";
    } else if (byte == '\t') {
      shown += "\\t";
    } else if (byte < 0x20 || byte == 0x7f) {
      shown.append("\\x").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    } else {
      shown += c;
    }
  }
  return shown + (text.size() > kLongestShown ? "...'" : "'");
}

}  // namespace voronaut
