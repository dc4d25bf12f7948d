#include "voronaut/reports/summary/results_page.h"

#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using Align = TextTable::Align;

TextTable table_of(const std::vector<std::string>& headings) {
  TextTable table;
  for (const std::string& heading : headings) table.columns.push_back({heading, Align::left});
  return table;
}

std::string or_dash(std::string_view text) { return std::string(text.empty() ? "-" : text); }

std::string outcomes() {
  TextTable table = table_of({"outcome", "sign", "what happened", "failure", "cut off"});
  for (const OutcomeEntry& entry : kOutcomes)
    table.rows.push_back({std::string(entry.name), std::string(entry.sign),
                          std::string(entry.meaning), entry.failure ? "yes" : "no",
                          entry.cut_off ? "yes" : "no"});
  return table.markdown();
}

std::string columns() {
  TextTable table = table_of({"column", "unit", "what it is", "over", "measured"});
  for (const RecordColumn& column : record_columns())
    table.rows.push_back({std::string(column.name), or_dash(column.unit), std::string(column.about),
                          std::string(words(column.rows)),
                          column.kind == ColumnKind::measured ? "yes" : "no"});
  return table.markdown();
}

std::string better(const Statistic& statistic) {
  if (statistic.better == Better::neither) return "-";
  return statistic.better == Better::more ? "more" : "less";
}

std::string statistics_table() {
  TextTable table = table_of({"statistic", "unit", "better", "what it is"});
  for (const Statistic& one : statistics())
    table.rows.push_back(
        {std::string(one.name), or_dash(unit_of(one)), better(one), description_of(one)});
  return table.markdown();
}

}  // namespace

std::string results_page() {
  return "# Results\n\n`voronaut list results` prints this page.\n\n## Outcomes\n\nA trial that is "
         "cut "
         "off says that something is wrong with the planner or the suite, not how well it flew: "
         "`voronaut run` ends with exit code 1. Every failure stays in the denominators.\n\n" +
         outcomes() +
         "\n## Columns\n\nOf a record: `results.csv`, table `trials` of `results.db`, exports. "
         "What is "
         "measured differs from run to run and is not part of the digest; an absent number is NULL "
         "in SQL and empty in CSV.\n\n" +
         columns() +
         "\n## Statistics\n\nOf the trials of one planner in one group of scenarios: `voronaut "
         "summary` "
         "(all of them with `--json` and `--csv`), the report, docs/evidence.md. A share has "
         "Wilson's "
         "95 % interval, the others a bootstrap interval, the smallest none. An acceptance "
         "criterion "
         "bounds a statistic by its name with `_min` where more is better, `_max` where less "
         "is.\n\n" +
         statistics_table();
}

}  // namespace voronaut
