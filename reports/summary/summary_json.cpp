#include <cmath>

#include "voronaut/reports/page/json_text.h"
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

}  // namespace

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
