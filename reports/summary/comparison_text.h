#pragma once

#include <string>

#include "voronaut/reports/summary/comparison.h"

namespace voronaut {

// What changed, a row for each planner and statistic that has a value: the change with its 95 %
// interval, the test, p corrected after Holm, and what it would take to see the tolerance.
std::string comparison_text(const RunComparison& comparison);
std::string comparison_markdown(const RunComparison& comparison);

// "McNemar, exact", "bootstrap over worlds".
std::string test_name(const Statistic& statistic, const Change& change);

// Everything in RunComparison; of the records what tells the trial, its outcome and its reason.
// Absent numbers are null.
std::string comparison_json(const RunComparison& comparison);

}  // namespace voronaut
