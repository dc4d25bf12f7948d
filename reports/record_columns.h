#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "voronaut/reports/run_record.h"

// The one list of the columns of a record. CSV, SQL, digest, exports and the page iterate it.
namespace voronaut {

enum class ColumnKind {
  deterministic,  // equal on every run of the same trial: part of the digest
  repeatable,     // equal as well, but no part of the digest: says something of the world, or is
                  // younger than digests that stand
  measured,       // wall times and what hangs on them
};

// The trials that a column or a statistic is over.
enum class TrialSet {
  all,
  moved,         // those that came to have the value: one that never started has none
  goal_reached,  // those of them that reached the goal
};

std::string_view words(TrialSet trials);

using RecordMember = std::variant<std::string RunRecord::*, std::int64_t RunRecord::*,
                                  double RunRecord::*, Outcome RunRecord::*>;

struct RecordColumn {
  std::string_view name;
  RecordMember member;
  ColumnKind kind;
  TrialSet trials;
  std::string_view unit;   // as it is written to people; empty for a text, a count or a ratio
  std::string_view about;  // part of a sentence: a heading or a tooltip
};

// In the order of the table.
std::span<const RecordColumn> record_columns();

// The column of a member.
const RecordColumn& column_of(RecordMember member);

// v(column, member of `record`), in the order of the table.
template <class Record, class Visitor>
void visit_columns(Record& record, Visitor&& v) {
  for (const RecordColumn& column : record_columns())
    std::visit([&](auto member) { v(column, record.*member); }, column.member);
}

// A cell of a record as text: a number as the shortest decimal that reads back as the same, empty
// where it is absent, 0 for -0.0 (which SQLite does not keep apart), "inf" and "-inf".
std::string cell_text(double value);
std::string cell_text(const RunRecord& record, const RecordColumn& column);

}  // namespace voronaut
