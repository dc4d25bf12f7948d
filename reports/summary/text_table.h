#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voronaut {

struct TextTable {
  enum class Align { left, right };

  struct Column {
    std::string heading;
    Align align = Align::right;
  };

  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  // each as long as columns

  // Columns two blanks apart, no blanks at the end of a line. A line break in a heading makes two
  // lines of headings here, a blank in Markdown.
  std::string aligned() const;
  std::string markdown() const;
};

// Code points of a UTF-8 text; what a terminal uses as its width but for wide and combining ones.
std::size_t text_width(std::string_view utf8);

// Control characters, which could move a terminal's cursor, become '?'.
std::string printable(std::string_view text);

}  // namespace voronaut
