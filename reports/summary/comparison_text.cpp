#include "voronaut/reports/summary/comparison_text.h"

#include <cmath>
#include <cstdio>

#include "voronaut/reports/summary/statistic_text.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using Align = TextTable::Align;

std::string signed_percent(double share) { return (share > 0 ? "+" : "") + fixed(100 * share, 1); }

std::string unit_of_change(const Statistic& statistic) {
  return statistic.estimator == Estimator::rate ? " points" : " %";
}

// The changes of few pairs are not listed: of a median they are pairs, of the rest they are none.
std::string interval_text(const Statistic& statistic, const Change& change) {
  const Interval& interval = change.interval;
  if (std::isnan(interval.low)) return statistic.estimator == Estimator::smallest ? "-" : "too few";
  return "[" + signed_percent(interval.low) + ", " + signed_percent(interval.high) + "]";
}

std::string p_text(double p) {
  if (std::isnan(p)) return "-";
  if (p < 0.0001) return "< 0.0001";
  return fixed(p, 4);
}

std::string verdict_text(ChangeVerdict verdict) {
  if (verdict == ChangeVerdict::undecided) return "";
  return verdict == ChangeVerdict::better ? "better" : "worse";
}

TextTable change_table() {
  return {{{"scenarios", Align::left},
           {"vehicle", Align::left},
           {"planner", Align::left},
           {"statistic", Align::left},
           {"n"},
           {"change"},
           {"95 %"},
           {"test", Align::left},
           {"p (Holm)"},
           {"", Align::left},
           {"repetitions\nneeded"}},
          {}};
}

std::string statistic_name(const Statistic& statistic) {
  return std::string(statistic.label) + ", " + std::string(estimator_words(statistic));
}

void add_rows(TextTable& table, const PlannerChange& planner, const RunComparison& comparison) {
  for (std::size_t i = 0; i < comparison.statistics.size(); ++i) {
    const Statistic& statistic = *comparison.statistics[i];
    const Change& change = planner.changes[i];
    if (std::isnan(change.value)) continue;
    table.rows.push_back(
        {printable(planner.group.scenario_group), printable(planner.group.vehicle),
         printable(planner.planner), statistic_name(statistic), std::to_string(change.n),
         signed_percent(change.value) + unit_of_change(statistic), interval_text(statistic, change),
         std::isnan(change.p) ? "-" : test_name(statistic, change), p_text(change.p_holm),
         verdict_text(change.verdict), fixed(change.repetitions_needed, 0)});
  }
}

TextTable table_of(const RunComparison& comparison) {
  TextTable table = change_table();
  for (const PlannerChange& planner : comparison.changes) add_rows(table, planner, comparison);
  return table;
}

std::string counts_text(const RunComparison& comparison) {
  return std::to_string(comparison.changed) + " of " + std::to_string(comparison.pairs) +
         " trials flew differently, " + std::to_string(comparison.ended_differently) +
         " end differently; " + std::to_string(comparison.only_here) + " here and " +
         std::to_string(comparison.only_there) + " there have no partner.\n";
}

std::string legend_text(const RunComparison& comparison) {
  const std::string tolerance = fixed(100 * comparison.tolerance, 1);
  return "Better or worse: p, corrected after Holm over all rows, is below 0.05, and the interval "
         "lies\nbeyond the tolerance of " +
         tolerance + " points of a share, " + tolerance + " % of the rest." +
         (comparison.tolerance > 0
              ? " Repetitions needed: to see\na change of the tolerance in 80 % of runs.\n"
              : "\n");
}

}  // namespace

std::string test_name(const Statistic& statistic, const Change& change) {
  if (statistic.estimator == Estimator::rate) return "McNemar, exact";
  return std::string("bootstrap over ") + (change.over_worlds ? "worlds" : "pairs");
}

std::string comparison_text(const RunComparison& comparison) {
  return "against " + printable(comparison.title) + ": " + counts_text(comparison) + "\n" +
         table_of(comparison).aligned() + "\n" + legend_text(comparison);
}

std::string comparison_markdown(const RunComparison& comparison) {
  return "**against " + printable(comparison.title) + "**\n\n" + table_of(comparison).markdown() +
         "\n" + counts_text(comparison) + "\n" + legend_text(comparison);
}

}  // namespace voronaut
