#include "voronaut/benchmarks/results/evidence_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

#include "voronaut/reports/summary/barn_score.h"
#include "voronaut/reports/summary/path_ratio.h"
#include "voronaut/reports/summary/statistics.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

constexpr const char* kBarn = "barn";  // the group of those worlds, which have a score of their own

std::string fixed(double value, int digits) {
  if (std::isnan(value)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string with_interval(const Estimate& estimate) {
  if (estimate.n == 0) return "-";
  std::string text = fixed(estimate.value, 3);
  if (!std::isnan(estimate.interval.low))
    text += " [" + fixed(estimate.interval.low, 3) + ", " + fixed(estimate.interval.high, 3) + "]";
  return text;
}

// What a row of the table counts.
struct Tally {
  std::int64_t n = 0;
  std::map<Outcome, std::int64_t> outcomes;
  double clearance_min_m = kAbsent;
  std::vector<double> path_ratios;  // of the trials that reached the goal
  std::vector<double> path_ratios_at_clearance;
  double barn_scores = 0;  // their sum

  void add(const RunRecord& record) {
    ++n;
    barn_scores += barn_score(record);
    ++outcomes[record.outcome];
    clearance_min_m = std::fmin(clearance_min_m, record.clearance_min_m);
    if (!std::isnan(record.path_ratio)) path_ratios.push_back(record.path_ratio);
    const double at_clearance = path_ratio_at_clearance(record);
    if (!std::isnan(at_clearance)) path_ratios_at_clearance.push_back(at_clearance);
  }
  std::int64_t count(Outcome outcome) const {
    const auto found = outcomes.find(outcome);
    return found == outcomes.end() ? 0 : found->second;
  }
  std::string other_outcomes() const {
    std::string text;
    for (const auto& [outcome, count] : outcomes) {
      if (outcome == Outcome::goal_reached || outcome == Outcome::collision) continue;
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " +
              std::string(to_string(outcome));
    }
    return text.empty() ? "-" : text;
  }
};

std::vector<std::string> row(const Tally& tally) {
  const Rate reached = wilson_rate(tally.count(Outcome::goal_reached), tally.n);
  return {std::to_string(tally.n),
          std::to_string(reached.successes),
          fixed(100 * reached.interval.low, 2) + " .. " + fixed(100 * reached.interval.high, 2),
          std::to_string(tally.count(Outcome::collision)),
          tally.other_outcomes(),
          fixed(tally.clearance_min_m, 3),
          with_interval(mean_estimate(tally.path_ratios)),
          with_interval(quantile_estimate(tally.path_ratios, 0.95)),
          with_interval(mean_estimate(tally.path_ratios_at_clearance))};
}

std::string table(const std::vector<RunRecord>& records) {
  std::map<std::tuple<std::string, std::string, std::string>, Tally> tallies;
  for (const RunRecord& record : records)
    tallies[{record.scenario_group, record.vehicle, record.planner}].add(record);
  using Align = TextTable::Align;
  TextTable result;
  for (const char* heading : {"worlds", "vehicle", "planner"})
    result.columns.push_back({heading, Align::left});
  for (const char* heading : {"n", "reached", "of 100", "collisions", "other", "clearance_min_m",
                              "path_ratio mean", "path_ratio 95 %", "mean at clearance_min_m"})
    result.columns.push_back({heading, Align::right});
  const bool of_barn = !tallies.empty() && std::get<0>(tallies.begin()->first) == kBarn;
  if (of_barn) result.columns.push_back({"BARN score", Align::right});
  for (const auto& [key, tally] : tallies) {
    std::vector<std::string> cells = {std::get<0>(key), std::get<1>(key), std::get<2>(key)};
    for (std::string& cell : row(tally)) cells.push_back(std::move(cell));
    if (of_barn) cells.push_back(fixed(tally.barn_scores / static_cast<double>(tally.n), 3));
    result.rows.push_back(std::move(cells));
  }
  return result.markdown();
}

std::string section(const SuiteEvidence& evidence, bool& holds) {
  std::string text = "## " + evidence.suite + "\n\n" + evidence.about + "\n\n";
  for (const Claim& claim : evidence.claims) {
    const Finding finding = examine(claim, evidence.records);
    holds = holds && finding.holds;
    text += std::string(finding.holds ? "- holds: " : "- **broken**: ") + finding.text + "\n";
  }
  if (!evidence.claims.empty()) text += "\n";
  return text + table(evidence.records) + "\nFlown " + evidence.started_utc + " by commit " +
         evidence.commit + ", digest `" + evidence.digest + "`.\n";
}

}  // namespace

EvidencePage evidence_page(const std::vector<SuiteEvidence>& suites) {
  EvidencePage page;
  Tally all;
  std::string sections, collisions;
  for (const SuiteEvidence& evidence : suites) {
    const std::int64_t before = all.count(Outcome::collision);
    for (const RunRecord& record : evidence.records) all.add(record);
    if (const std::int64_t added = all.count(Outcome::collision) - before; added > 0)
      collisions +=
          (collisions.empty() ? " (" : ", ") + std::to_string(added) + " in " + evidence.suite;
    sections += "\n" + section(evidence, page.holds);
  }
  page.markdown =
      "# Evidence\n\n`./quickstart evidence` flies the suites in "
      "`benchmarks/suites/evidence/`, and the `real-` ones where VORONAUT_DATA is set, and writes "
      "this page. Failures stay in every "
      "denominator; \"of 100\" is Wilson's 95 % interval of those that reached the "
      "goal, the others are bootstrap intervals over arrivals. Path ratios are over the body's "
      "shortest "
      "path on the true world; the last column over the shortest one at `clearance_min_m`.\n\n" +
      std::to_string(suites.size()) + " suites, " + std::to_string(all.n) + " flights, " +
      std::to_string(all.count(Outcome::collision)) + " collisions" +
      (collisions.empty() ? "" : collisions + ")") + ", smallest clearance " +
      fixed(all.clearance_min_m, 3) + " m. " +
      (page.holds ? "Every claim holds." : "**Not every claim holds.**") + "\n" + sections;
  return page;
}

}  // namespace voronaut
