#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/axis_columns.h"
#include "voronaut/reports/summary/summary.h"

namespace voronaut {

// Tables with aligned columns for a terminal: one per group, the pooled ones last, then who beats
// whom. Control characters in names are shown as '?'.
std::string summary_text(const Summary& summary);

// The same tables in Markdown, for a paper or a pull request.
std::string summary_markdown(const Summary& summary);

// One line per group and planner: of every statistic its value, the ends of its interval and over
// how many trials it is; before them a column for each axis of the suite's sweep.
std::string summary_csv(const Summary& summary, const std::vector<AxisColumn>& axes = {});

// Everything in Summary: {"groups":[...], "totals":[...], "pairings":[...], "statistics":[...]},
// the last the table of statistics itself. Absent numbers are null. Where there are axes, each
// group has "axes": {path: value as text}.
std::string summary_json(const Summary& summary, const std::vector<AxisColumn>& axes = {});

}  // namespace voronaut
