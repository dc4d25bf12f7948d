#include <cmath>

#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/summary/summary_text.h"

namespace voronaut {

namespace {

using nlohmann::json;

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json interval(const Interval& i) { return json::array({number(i.low), number(i.high)}); }

json estimate(const Estimate& e) {
  return {{"value", number(e.value)}, {"interval", interval(e.interval)}, {"n", e.n}};
}

json rate(const Rate& r) {
  return {{"value", number(r.value)},
          {"interval", interval(r.interval)},
          {"successes", r.successes},
          {"n", r.n}};
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
  out["success"] = rate(s.success);
  out["collisions"] = rate(s.collisions);
  out["outcomes"] = json::object();
  for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
    out["outcomes"][std::string(to_string(kOutcomes[i]))] = s.outcomes[i];
  }
  out["path_ratio_median"] = estimate(s.path_ratio_median);
  out["path_ratio_p95"] = estimate(s.path_ratio_p95);
  out["spl_mean"] = estimate(s.spl_mean);
  out["duration_median_s"] = estimate(s.duration_median_s);
  out["clearance_min_m"] = number(s.clearance_min_m);
  out["clearance_median_m"] = estimate(s.clearance_median_m);
  out["speed_mean_median_m_s"] = estimate(s.speed_mean_median_m_s);
  out["replans_median"] = estimate(s.replans_median);
  out["state_checks_median"] = estimate(s.state_checks_median);
  out["planning_time_us_median"] = estimate(s.planning_time_us_median);
  out["step_time_us_median"] = estimate(s.step_time_us_median);
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
  out["win_share_a"] = rate(p.win_share_a);
  return out;
}

json change_to_json(const PlannerChange& c) {
  json out = group_fields(c.group);
  out["planner"] = c.planner;
  out["n"] = c.n;
  out["reached_before"] = rate(c.reached_before);
  out["reached_now"] = rate(c.reached_now);
  out["gained"] = c.gained;
  out["lost"] = c.lost;
  out["success_change"] = estimate(c.success_change);
  out["path_ratio_change"] = estimate(c.path_ratio_change);
  out["duration_change"] = estimate(c.duration_change);
  out["state_checks_change"] = estimate(c.state_checks_change);
  out["planning_time_change"] = estimate(c.planning_time_change);
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
  json out{{"title", comparison.title},         {"commit", comparison.commit},
           {"only_here", comparison.only_here}, {"only_there", comparison.only_there},
           {"changes", json::array()},          {"outcomes", json::array()}};
  for (const PlannerChange& c : comparison.changes) {
    out["changes"].push_back(change_to_json(c));
  }
  for (const OutcomeChange& c : comparison.outcomes) {
    out["outcomes"].push_back(outcome_to_json(c));
  }
  return json_text(out);
}

std::string summary_json(const Summary& summary) {
  json out{{"groups", json::array()}, {"totals", json::array()}, {"pairings", json::array()}};
  for (const PlannerSummary& s : summary.groups) {
    out["groups"].push_back(planner_to_json(s));
  }
  for (const PlannerSummary& s : summary.totals) {
    out["totals"].push_back(planner_to_json(s));
  }
  for (const PlannerPairing& p : summary.pairings) {
    out["pairings"].push_back(pairing_to_json(p));
  }
  return json_text(out);
}

}  // namespace voronaut
