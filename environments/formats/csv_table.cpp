#include "voronaut/environments/formats/csv_table.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/environments/formats/text_lines.h"

namespace voronaut {
namespace {

std::string trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(kBlank) - first + 1));
}

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return fields;
}

}  // namespace

CsvTable CsvTable::read(const std::string& path, const std::vector<std::string>& required_columns) {
  return parse(read_text_file(path), path, required_columns);
}

CsvTable CsvTable::parse(const std::string& text, const std::string& path,
                         const std::vector<std::string>& required_columns) {
  CsvTable table;
  table.path_ = path;
  std::istringstream stream{std::string(without_byte_order_mark(text))};
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (trimmed(line).empty()) continue;
    std::vector<std::string> fields = fields_of(line);
    if (table.columns_.empty()) {
      for (const std::string& column : required_columns)
        if (std::find(fields.begin(), fields.end(), column) == fields.end())
          throw ConfigError(path, line_number, "",
                            "column '" + column + "' is missing; the header is " + in_quotes(line));
      table.columns_ = std::move(fields);
    } else if (fields.size() != table.columns_.size()) {
      throw ConfigError(path, line_number, "",
                        "expected " + std::to_string(table.columns_.size()) + " fields, got " +
                            std::to_string(fields.size()));
    } else {
      table.rows_.push_back({line_number, std::move(fields)});
    }
  }
  if (table.columns_.empty()) throw ConfigError(path, 1, "", "the file is empty");
  return table;
}

bool CsvTable::has(std::string_view column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

std::size_t CsvTable::index_of(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) std::abort();  // only columns that are there are ever asked for
  return static_cast<std::size_t>(found - columns_.begin());
}

const std::string& CsvTable::text(std::size_t row, std::string_view column) const {
  return rows_[row].fields[index_of(column)];
}

double CsvTable::number(std::size_t row, std::string_view column, double lo, double hi) const {
  const std::string& field = text(row, column);
  const auto value = parse_number(field);
  if (!value || *value < lo || *value > hi)
    throw ConfigError(path_, rows_[row].line, "",
                      "column '" + std::string(column) + "': expected a number from " +
                          number_text(lo) + " to " + number_text(hi) + ", got " + in_quotes(field));
  return *value;
}

std::vector<Circle> read_circles_csv(const std::string& path) {
  return parse_circles_csv(read_text_file(path), path);
}

std::vector<Circle> parse_circles_csv(const std::string& text, const std::string& path) {
  const CsvTable table = CsvTable::parse(text, path, {"x", "y", "r"});
  std::vector<Circle> circles;
  circles.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = table.number(row, "x", -kFarthestCoordinate, kFarthestCoordinate);
    const double y = table.number(row, "y", -kFarthestCoordinate, kFarthestCoordinate);
    circles.push_back({{x, y}, table.number(row, "r", kSmallestRadius, kLargestRadius)});
  }
  return circles;
}

}  // namespace voronaut
