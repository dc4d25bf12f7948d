#include "voronaut/reports/store/csv_writer.h"

#include "voronaut/reports/record_columns.h"

namespace voronaut {

std::string csv_field(std::string_view text) {
  const bool guarded = text.find_first_of("=+-@\t\r'") == 0;
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return (guarded ? "'" : "") + std::string(text);
  }
  std::string quoted = guarded ? "\"'" : "\"";
  for (const char c : text) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + '"';
}

std::string records_to_csv(const std::vector<RunRecord>& records) {
  std::string csv;
  for (const RecordColumn& column : record_columns())
    csv.append(csv.empty() ? "" : ",").append(column.name);
  csv += "\r\n";
  for (const RunRecord& record : records) {
    std::string line;
    for (const RecordColumn& column : record_columns()) {
      const bool is_text = std::holds_alternative<std::string RunRecord::*>(column.member);
      const std::string cell = cell_text(record, column);
      line +=
          (&column == &record_columns().front() ? "" : ",") + (is_text ? csv_field(cell) : cell);
    }
    csv += line + "\r\n";
  }
  return csv;
}

}  // namespace voronaut
