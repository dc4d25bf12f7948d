#include "voronaut/benchmarks/results/evidence_page.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "voronaut/reports/summary/statistic_text.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

struct Row {
  std::vector<std::string> subject;  // worlds, vehicle, planner
  OutcomeCounts counts{};
  std::vector<Estimate> estimates;  // in the order of statistics_shown(kEvidence)
};

std::vector<Row> rows_of(const std::vector<RunRecord>& records) {
  std::map<std::tuple<std::string, std::string, std::string>, Trials> groups;
  for (const RunRecord& record : records)
    groups[{record.scenario_group, record.vehicle, record.planner}].push_back(&record);
  std::vector<Row> rows;
  for (const auto& [key, trials] : groups) {
    const auto& [worlds, vehicle, planner] = key;
    Row& row = rows.emplace_back(Row{{worlds, vehicle, planner}, outcome_counts(trials), {}});
    for (const Statistic* one : statistics_shown(kEvidence))
      row.estimates.push_back(estimate_of(*one, trials));
  }
  return rows;
}

// What no row has a value of is not shown.
std::string table(const std::vector<RunRecord>& records) {
  using Align = TextTable::Align;
  const std::vector<Row> rows = rows_of(records);
  TextTable result;
  for (const char* name : {"worlds", "vehicle", "planner"})
    result.columns.push_back({name, Align::left});
  for (const Row& row : rows) result.rows.push_back(row.subject);
  const auto shown = statistics_shown(kEvidence);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    if (std::none_of(rows.begin(), rows.end(), [k](const Row& r) { return r.estimates[k].n > 0; }))
      continue;
    result.columns.push_back({heading(*shown[k])});
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.rows[i].push_back(full_text(*shown[k], rows[i].estimates[k], rows[i].counts));
  }
  result.columns.push_back({"ended otherwise", Align::left});
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.rows[i].push_back(other_outcomes(rows[i].counts, kEvidence));
  return result.markdown();
}

std::string section(const SuiteEvidence& evidence, bool& holds) {
  std::string text = "## " + evidence.suite + "\n\n" + evidence.about + "\n\n";
  for (const AcceptanceCriterion& criterion : evidence.criteria) {
    const Finding finding = examine(criterion, evidence.records);
    holds = holds && finding.holds;
    text += std::string(finding.holds ? "- holds: " : "- **broken**: ") + finding.text + "\n";
  }
  if (!evidence.criteria.empty()) text += "\n";
  return text + table(evidence.records) + "\nFlown " + evidence.started_utc + " by commit " +
         evidence.commit + ", digest `" + evidence.digest + "`.\n";
}

std::int64_t collisions_of(const std::vector<RunRecord>& records) {
  return std::count_if(records.begin(), records.end(),
                       [](const RunRecord& r) { return r.outcome == Outcome::collision; });
}

// "24 suites, 115432 flights, ...".
std::string sums(const std::vector<SuiteEvidence>& suites) {
  Trials all;
  std::int64_t collisions = 0;
  std::string where;
  for (const SuiteEvidence& evidence : suites) {
    for (const RunRecord& record : evidence.records) all.push_back(&record);
    const std::int64_t here = collisions_of(evidence.records);
    collisions += here;
    if (here > 0)
      where += (where.empty() ? " (" : ", ") + std::to_string(here) + " in " + evidence.suite;
  }
  const Statistic& clearance = statistic("clearance_smallest_m");
  return std::to_string(suites.size()) + " suites, " + std::to_string(all.size()) + " flights, " +
         std::to_string(collisions) + " collisions" + (where.empty() ? "" : where + ")") +
         ", smallest clearance " + fixed(estimate_of(clearance, all).value, clearance.digits) +
         " m. ";
}

}  // namespace

EvidencePage evidence_page(const std::vector<SuiteEvidence>& suites) {
  EvidencePage page;
  std::string sections;
  for (const SuiteEvidence& evidence : suites) sections += "\n" + section(evidence, page.holds);
  page.markdown =
      "# Evidence\n\n`./quickstart evidence` flies the suites in "
      "`benchmarks/suites/evidence/`, and the `real-` ones where VORONAUT_DATA is set, and writes "
      "this page. Failures stay in every denominator of a share; brackets are 95 % intervals, "
      "Wilson's of a share in percent, else bootstrapped. Path ratios are over trials that reached "
      "the goal, against the body's shortest path on the true world; \"at clearance\\_min\\_m\" "
      "against the shortest one at that clearance, which is all that planners may take. "
      "[results.md](results.md) says what each number is.\n\n" +
      sums(suites) +
      (page.holds ? "Every acceptance criterion holds."
                  : "**Not every acceptance criterion holds.**") +
      "\n" + sections;
  return page;
}

}  // namespace voronaut
