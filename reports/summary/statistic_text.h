#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "voronaut/reports/summary/statistics.h"

// How numbers of the table of statistics are written, wherever people read them.
namespace voronaut {

// "-" for NaN; halves away from zero, as the report's JavaScript rounds what is positive.
std::string fixed(double value, int digits);

// What follows a bootstrapped value: its interval, or that the values are too few for one, and
// them. " [1.200, 1.300]", " (too few: 1.1, 1.3)", " (one value)"; empty where no interval is asked
// for.
std::string spread_text(const Estimate& estimate, int digits);

// Label, a line break, estimator and unit.
std::string heading(const Statistic& statistic);

// How many trials ended in each way, in the order of kOutcomes.
using OutcomeCounts = std::array<std::int64_t, kOutcomes.size()>;
OutcomeCounts outcome_counts(const Trials& trials);

// "1.250", "50.0 % [9.5, 90.5]". Says over how many where not all of its trials have a value.
std::string brief_text(const Statistic& statistic, const Estimate& estimate,
                       const OutcomeCounts& counts);
// The same with the interval, and of a rate with the counts: "1.250 [1.200, 1.300]", "1 of 2, ...",
// "1.2 (too few: 1.1, 1.3)".
std::string full_text(const Statistic& statistic, const Estimate& estimate,
                      const OutcomeCounts& counts);

// "3 stuck, 1 crash": those of which `output` shows no share; empty for none. Of static planning,
// where nothing has flown, a timeout is a spent budget.
std::string other_outcomes(const OutcomeCounts& counts, Output output, bool flown = true);

}  // namespace voronaut
