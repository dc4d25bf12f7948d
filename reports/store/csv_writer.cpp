#include "voronaut/reports/store/csv_writer.h"

#include <ostream>

#include "voronaut/reports/axis_columns.h"
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

using Axes = std::vector<AxisColumn>;

std::string csv_heading(const Axes& axes) {
  std::string line;
  for (const RecordColumn& column : record_columns())
    line.append(line.empty() ? "" : ",").append(column.name);
  for (const AxisColumn& axis : axes) line += "," + csv_field(axis.path);
  return line + "\r\n";
}

std::string csv_line(const RunRecord& record, const Axes& axes) {
  std::string line;
  for (const RecordColumn& column : record_columns()) {
    const bool is_text = std::holds_alternative<std::string RunRecord::*>(column.member);
    const std::string cell = cell_text(record, column);
    line += (&column == &record_columns().front() ? "" : ",") + (is_text ? csv_field(cell) : cell);
  }
  for (const AxisColumn& axis : axes) line += "," + csv_field(axis.value_of(record));
  return line + "\r\n";
}

}  // namespace

std::string records_to_csv(const std::vector<RunRecord>& records) {
  std::string csv = csv_heading({});
  for (const RunRecord& record : records) csv += csv_line(record, {});
  return csv;
}

void write_csv_of(const ResultStore& store, std::ostream& out) {
  const Axes axes = axis_columns(store.meta("sweep").value_or(""));
  out << csv_heading(axes);
  store.for_each_record([&](const RunRecord& record) { out << csv_line(record, axes); });
}

}  // namespace voronaut
