#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/store/store.h"

namespace voronaut {

// A text field as RFC 4180 wants it: in quotes, quotes doubled, if it holds a comma, a quote or a
// line break. One that begins with = + - @, a tab, a carriage return or an apostrophe gets an
// apostrophe in front, so that no spreadsheet takes it for a formula; taking one apostrophe off
// gives the text back.
std::string csv_field(std::string_view text);

// One header line with the names of RunRecord::visit, then one line per record, in the given order.
// Lines end in CRLF (RFC 4180), numbers are the shortest text that reads back as the same double,
// absent numbers are empty.
std::string records_to_csv(const std::vector<RunRecord>& records);
// The same of all records of a store, by trial_id, and after them a column for each axis of the
// sweep that its suite made.
void write_csv_of(const ResultStore& store, std::ostream& out);

}  // namespace voronaut
