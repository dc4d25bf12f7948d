#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/config/config_error.h"

namespace voronaut {

// A text without the mark by which some editors begin UTF-8.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

// A text line by line, for readers of foreign formats that must say in which line a fault is. The
// text must outlive it. "\r\n" ends a line too; a byte order mark is left out.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file)
      : rest_(without_byte_order_mark(text)), file_(std::move(file)) {}

  // Goes to the next line; false if there is none.
  bool next();
  std::string_view line() const { return line_; }
  int number() const { return number_; }
  // Its parts between blanks and tabs.
  std::vector<std::string_view> words() const;

  // A finite number or a whole one from a word of this line, within inclusive bounds; `what` names
  // it in the error: "start x".
  double real(std::string_view word, std::string_view what, double lo, double hi) const;
  std::int64_t whole(std::string_view word, std::string_view what, std::int64_t lo,
                     std::int64_t hi) const;

  // Refuses anything but blank lines from here on.
  void expect_blank_rest();

  // A fault in this line; at the end of the file, in its last one; of an empty file, in the first.
  ConfigError error(std::string_view problem) const {
    return {file_, std::max(number_, 1), "", problem};
  }

 private:
  std::string_view rest_;
  std::string file_;
  std::string_view line_;
  int number_ = 0;
};

}  // namespace voronaut
