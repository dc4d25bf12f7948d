#include "voronaut/reports/store/csv_writer.h"

#include <ostream>

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

namespace {

std::string csv_heading() {
  std::string line;
  for (const RecordColumn& column : record_columns())
    line.append(line.empty() ? "" : ",").append(column.name);
  return line + "\r\n";
}

std::string csv_line(const RunRecord& record) {
  std::string line;
  for (const RecordColumn& column : record_columns()) {
    const bool is_text = std::holds_alternative<std::string RunRecord::*>(column.member);
    const std::string cell = cell_text(record, column);
    line += (&column == &record_columns().front() ? "" : ",") + (is_text ? csv_field(cell) : cell);
  }
  return line + "\r\n";
}

}  // namespace

std::string records_to_csv(const std::vector<RunRecord>& records) {
  std::string csv = csv_heading();
  for (const RunRecord& record : records) csv += csv_line(record);
  return csv;
}

void write_csv_of(const ResultStore& store, std::ostream& out) {
  out << csv_heading();
  store.for_each_record([&](const RunRecord& record) { out << csv_line(record); });
}

}  // namespace voronaut
