#include "voronaut/reports/store/csv_writer.h"

#include <type_traits>

#include "voronaut/reports/summary/column_text.h"

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
  const auto put = [&csv](std::string_view field, bool& first) {
    csv.append(first ? "" : ",").append(field);
    first = false;
  };
  bool first = true;
  RunRecord().visit([&](const char* name, const auto&, ColumnKind) { put(name, first); });
  csv += "\r\n";
  for (const RunRecord& record : records) {
    first = true;
    record.visit([&](const char*, const auto& value, ColumnKind) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, Outcome>) {
        put(to_string(value), first);
      } else if constexpr (std::is_same_v<Value, std::int64_t>) {
        put(std::to_string(value), first);
      } else if constexpr (std::is_same_v<Value, double>) {
        put(column_text(value), first);
      } else {
        put(csv_field(value), first);
      }
    });
    csv += "\r\n";
  }
  return csv;
}

}  // namespace voronaut
