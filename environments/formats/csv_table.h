#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/environments/shapes/geometry.h"

// Tables in comma-separated text with a header line: foreign worlds come in them.
namespace voronaut {

// Fields are trimmed; quotes have no meaning; empty lines are skipped; "\r\n" ends a line too.
class CsvTable {
 public:
  // Throws ConfigError for a file that cannot be read, is empty, lacks one of these columns or has
  // a row of another length.
  static CsvTable read(const std::string& path, const std::vector<std::string>& required_columns);
  // The same of a text; `path` is what errors call it.
  static CsvTable parse(const std::string& text, const std::string& path,
                        const std::vector<std::string>& required_columns);

  std::size_t rows() const { return rows_.size(); }
  bool has(std::string_view column) const;
  const std::string& text(std::size_t row, std::string_view column) const;
  // Throws ConfigError with file, line and column unless it is a finite number within the bounds.
  double number(std::size_t row, std::string_view column, double lo, double hi) const;
  int line(std::size_t row) const { return rows_[row].line; }

 private:
  struct Row {
    int line = 0;
    std::vector<std::string> fields;
  };

  std::size_t index_of(std::string_view column) const;

  std::string path_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

// Coordinates and radii that a world may have, in m: what lies beyond is a slip of the pen.
inline constexpr double kFarthestCoordinate = 100'000;
inline constexpr double kSmallestRadius = 0.001;
inline constexpr double kLargestRadius = 1'000;

// A list of circles: columns x, y, r in m; others are ignored.
std::vector<Circle> read_circles_csv(const std::string& path);
std::vector<Circle> parse_circles_csv(const std::string& text, const std::string& path);

}  // namespace voronaut
