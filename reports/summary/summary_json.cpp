#include <cmath>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/summary/comparison_text.h"
#include "voronaut/reports/summary/published_results.h"
#include "voronaut/reports/summary/summary_text.h"

namespace voronaut {

namespace {

using nlohmann::json;

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json interval(const Interval& i) { return json::array({number(i.low), number(i.high)}); }

json estimate(const Estimate& e) {
  json out{{"value", number(e.value)}, {"interval", interval(e.interval)}, {"n", e.n}};
  for (const double value : e.too_few) out["too_few"].push_back(number(value));
  return out;
}

json rate_json(const Estimate& r) {
  json out = estimate(r);
  out["successes"] = r.successes;
  return out;
}

json estimate(const Statistic& statistic, const Estimate& e) {
  return statistic.estimator == Estimator::rate ? rate_json(e) : estimate(e);
}

std::string_view name_of(Better better) {
  if (better == Better::more) return "more";
  return better == Better::less ? "less" : "";
}

json statistic_to_json(const Statistic& s) {
  const RecordColumn* column = column_of(s);
  return {{"name", s.name},
          {"column", column != nullptr ? column->name : ""},
          {"label", s.label},
          {"heading", heading(s)},
          {"about", description_of(s)},
          {"unit", unit_of(s)},
          {"rate", s.estimator == Estimator::rate},
          {"better", name_of(s.better)},
          {"digits", s.digits},
          {"of_reached", s.trials == TrialSet::goal_reached},
          {"question", s.question},
          {"logarithmic", s.axis == Axis::logarithmic},
          {"in_table", (s.shown & kPage) != 0},
          {"in_sweeps", (s.shown & kSweep) != 0},
          {"in_comparison", (s.shown & kComparison) != 0}};
}

json group_fields(const SummaryGroup& group) {
  return {{"scenario_group", group.scenario_group},
          {"all_scenarios", group.all_scenarios},
          {"vehicle", group.vehicle},
          {"regulator", group.regulator}};
}

json planner_to_json(const PlannerSummary& s) {
  json out = group_fields(s.group);
  out["planner"] = s.planner;
  out["n"] = s.n;
  out["rank"] = s.rank;
  for (const OutcomeEntry& entry : kOutcomes)
    out["outcomes"][std::string(entry.name)] = s.outcomes[static_cast<std::size_t>(entry.outcome)];
  for (const Statistic& one : statistics())
    out["statistics"][std::string(one.name)] = estimate(one, s.of(one.name));
  return out;
}

json pairing_to_json(const PlannerPairing& p) {
  json out = group_fields(p.group);
  out["planner_a"] = p.planner_a;
  out["planner_b"] = p.planner_b;
  out["n"] = p.n;
  out["wins_a"] = p.wins_a;
  out["ties"] = p.ties;
  out["wins_b"] = p.wins_b;
  out["win_share_a"] = rate_json(p.win_share_a);
  out["only_a"] = p.only_a;
  out["only_b"] = p.only_b;
  out["success_p_holm"] = number(p.success_p_holm);
  out["path_p_holm"] = number(p.path_p_holm);
  return out;
}

json change_to_json(const Statistic& statistic, const Change& change) {
  json out = estimate(change);
  out["p"] = number(change.p);
  out["p_holm"] = number(change.p_holm);
  out["test"] = std::isnan(change.p) ? "" : test_name(statistic, change);
  out["verdict"] = change.verdict == ChangeVerdict::undecided ? ""
                   : change.verdict == ChangeVerdict::better  ? "better"
                                                              : "worse";
  out["repetitions_needed"] = number(change.repetitions_needed);
  return out;
}

json changes_to_json(const PlannerChange& c, const RunComparison& comparison) {
  json out = group_fields(c.group);
  out["planner"] = c.planner;
  out["n"] = c.n;
  out["changed"] = c.changed;
  out["reached_before"] = rate_json(c.reached_before);
  out["reached_now"] = rate_json(c.reached_now);
  out["gained"] = c.gained;
  out["lost"] = c.lost;
  for (std::size_t i = 0; i < comparison.statistics.size(); ++i)
    out["changes"][std::string(comparison.statistics[i]->name)] =
        change_to_json(*comparison.statistics[i], c.changes[i]);
  return out;
}

json outcome_to_json(const OutcomeChange& c) {
  return {{"trial_id", c.now.trial_id},
          {"scenario", c.now.scenario},
          {"vehicle", c.now.vehicle},
          {"regulator", c.now.regulator},
          {"planner", c.now.planner},
          {"repetition", c.now.repetition},
          {"outcome_before", to_string(c.outcome_before)},
          {"outcome_now", to_string(c.now.outcome)},
          {"reason_now", c.now.reason}};
}

}  // namespace

std::string comparison_json(const RunComparison& comparison) {
  json out{{"title", comparison.title},
           {"commit", comparison.commit},
           {"tolerance", comparison.tolerance},
           {"worse", comparison.worse()},
           {"pairs", comparison.pairs},
           {"changed", comparison.changed},
           {"only_here", comparison.only_here},
           {"only_there", comparison.only_there},
           {"changes", json::array()},
           {"outcomes", json::array()},
           {"ended_differently", comparison.ended_differently}};
  for (const PlannerChange& c : comparison.changes) {
    out["changes"].push_back(changes_to_json(c, comparison));
  }
  for (const OutcomeChange& c : comparison.outcomes) {
    out["outcomes"].push_back(outcome_to_json(c));
  }
  return json_text(out);
}

std::string summary_json(const Summary& summary, const std::vector<AxisColumn>& axes) {
  json out{{"groups", json::array()},
           {"totals", json::array()},
           {"pairings", json::array()},
           {"statistics", json::array()}};
  for (const Statistic& one : statistics()) {
    out["statistics"].push_back(statistic_to_json(one));
  }
  for (const PlannerSummary& s : summary.groups) {
    json& group = out["groups"].emplace_back(planner_to_json(s));
    for (const AxisColumn& axis : axes)
      group["axes"][axis.path] = axis.value_of(s.group.scenario_group, s.group.vehicle, s.planner);
  }
  for (const PlannerSummary& s : summary.totals) {
    out["totals"].push_back(planner_to_json(s));
  }
  for (const PlannerPairing& p : summary.pairings) {
    out["pairings"].push_back(pairing_to_json(p));
  }
  return json_text(out);
}

std::string barn_json(const BarnComparison& comparison) {
  json standings = json::array(), differences = json::array();
  for (const BarnStanding& one : comparison.standings)
    standings.push_back({{"name", one.name},
                         {"vehicle", one.vehicle},
                         {"worlds", one.worlds},
                         {"reached", rate_json(one.reached)},
                         {"collided", rate_json(one.collided)},
                         {"score", estimate(one.score)},
                         {"time_s", estimate(one.time_s)}});
  for (const BarnDifference& one : comparison.differences)
    differences.push_back({{"planner", one.planner},
                           {"vehicle", one.vehicle},
                           {"method", one.method},
                           {"worlds", one.worlds},
                           {"score", estimate(one.score)},
                           {"p", number(one.p)},
                           {"p_holm", number(one.p_holm)}});
  return json_text(
      {{"worlds", comparison.worlds}, {"standings", standings}, {"differences", differences}});
}

}  // namespace voronaut
