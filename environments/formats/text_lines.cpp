#include "voronaut/environments/formats/text_lines.h"

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"

namespace voronaut {

bool TextLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

void TextLines::expect_blank_rest() {
  while (next())
    if (!words().empty()) throw error("expected the end of the file, got " + in_quotes(line_));
}

std::vector<std::string_view> TextLines::words() const {
  constexpr std::string_view kBlank = " \t";
  std::vector<std::string_view> words;
  for (std::size_t at = line_.find_first_not_of(kBlank); at != std::string_view::npos;) {
    const std::size_t end = line_.find_first_of(kBlank, at);
    words.push_back(line_.substr(at, end - at));
    at = end == std::string_view::npos ? end : line_.find_first_not_of(kBlank, end);
  }
  return words;
}

double TextLines::real(std::string_view word, std::string_view what, double lo, double hi) const {
  const auto value = parse_number(word);
  if (!value || *value < lo || *value > hi)
    throw error(std::string(what) + ": expected a number from " + number_text(lo) + " to " +
                number_text(hi) + ", got " + in_quotes(word));
  return *value;
}

std::int64_t TextLines::whole(std::string_view word, std::string_view what, std::int64_t lo,
                              std::int64_t hi) const {
  const auto value = parse_whole(word);
  if (!value || *value < lo || *value > hi)
    throw error(std::string(what) + ": expected a whole number from " + std::to_string(lo) +
                " to " + std::to_string(hi) + ", got " + in_quotes(word));
  return *value;
}

}  // namespace voronaut
