#include "voronaut/reports/summary/summary.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace voronaut {

namespace {

// Runs of digits compare as numbers, everything else by bytes.
bool natural_less(std::string_view a, std::string_view b) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto digits = [&](std::string_view text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    return text.substr(0, static_cast<std::size_t>(end - text.begin()));
  };
  while (!a.empty() && !b.empty()) {
    if (is_digit(a.front()) && is_digit(b.front())) {
      const std::string_view run_a = digits(a);
      const std::string_view run_b = digits(b);
      const std::string_view value_a =
          run_a.substr(std::min(run_a.find_first_not_of('0'), run_a.size()));
      const std::string_view value_b =
          run_b.substr(std::min(run_b.find_first_not_of('0'), run_b.size()));
      if (value_a != value_b) {
        return value_a.size() != value_b.size() ? value_a.size() < value_b.size()
                                                : value_a < value_b;
      }
      a.remove_prefix(run_a.size());
      b.remove_prefix(run_b.size());
    } else if (a.front() != b.front()) {
      return a.front() < b.front();
    } else {
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

struct InNaturalOrder {
  bool operator()(const SummaryGroup& a, const SummaryGroup& b) const {
    if (natural_less(a.scenario_group, b.scenario_group)) {
      return true;
    }
    return !natural_less(b.scenario_group, a.scenario_group) && a < b;
  }
};

using Trials = std::vector<const RunRecord*>;
// Trials of one group by planner; std::map so that the order is that of the names.
using Grouped = std::map<SummaryGroup, std::map<std::string, Trials>, InNaturalOrder>;

template <class Value>
std::vector<double> collect(const Trials& trials, Value&& value, bool reached_only = false) {
  std::vector<double> values;
  for (const RunRecord* trial : trials) {
    if (!reached_only || trial->outcome == Outcome::goal_reached) {
      values.push_back(static_cast<double>(value(*trial)));
    }
  }
  return values;
}

double smallest(const std::vector<double>& values) {
  double best = kAbsent;
  for (const double value : values) {
    best = std::isnan(best) || value < best ? value : best;
  }
  return best;
}

void count_outcomes(PlannerSummary& summary, const Trials& trials) {
  for (const RunRecord* trial : trials) {
    const auto at = std::find(kOutcomes.begin(), kOutcomes.end(), trial->outcome);
    ++summary.outcomes[static_cast<std::size_t>(at - kOutcomes.begin())];
  }
  summary.n = static_cast<std::int64_t>(trials.size());
  summary.success = wilson_rate(summary.outcomes[0], summary.n);
  summary.collisions = wilson_rate(summary.outcomes[1], summary.n);
}

PlannerSummary summarise_planner(const SummaryGroup& group, const std::string& planner,
                                 const Trials& trials, const BootstrapConfig& bootstrap) {
  PlannerSummary s;
  s.group = group;
  s.planner = planner;
  count_outcomes(s, trials);
  const auto median = [&](auto&& value, bool reached_only = false) {
    return quantile_estimate(collect(trials, value, reached_only), 0.5, bootstrap);
  };
  const auto path_ratio = [](const RunRecord& r) { return r.path_ratio; };
  const auto clearance = [](const RunRecord& r) { return r.clearance_min_m; };
  s.path_ratio_median = median(path_ratio, true);
  s.path_ratio_p95 = quantile_estimate(collect(trials, path_ratio, true), 0.95, bootstrap);
  // A trial that never started has no SPL of its own: it failed, so it counts 0.
  s.spl_mean = mean_estimate(
      collect(trials, [](const RunRecord& r) { return std::isnan(r.spl) ? 0.0 : r.spl; }),
      bootstrap);
  s.duration_median_s = median([](const RunRecord& r) { return r.duration_s; }, true);
  s.clearance_min_m = smallest(collect(trials, clearance));
  s.clearance_median_m = median(clearance);
  s.speed_mean_median_m_s = median([](const RunRecord& r) { return r.speed_mean_m_s; });
  s.replans_median = median([](const RunRecord& r) { return r.replans; });
  s.state_checks_median = median([](const RunRecord& r) { return r.state_checks; });
  s.planning_time_us_median = median([](const RunRecord& r) { return r.planning_time_us_mean; });
  s.step_time_us_median = median([](const RunRecord& r) { return r.step_time_us_mean; });
  return s;
}

// 1 if a is better, -1 if b is, 0 for a tie.
int compare(const RunRecord& a, const RunRecord& b, double tie_tolerance) {
  const bool a_reached = a.outcome == Outcome::goal_reached;
  const bool b_reached = b.outcome == Outcome::goal_reached;
  if (a_reached != b_reached) {
    return a_reached ? 1 : -1;
  }
  // Either may be absent, where no shortest path is known: no verdict then.
  if (!a_reached || !(std::abs(a.path_ratio - b.path_ratio) >
                      tie_tolerance * std::min(a.path_ratio, b.path_ratio))) {
    return 0;
  }
  return a.path_ratio < b.path_ratio ? 1 : -1;
}

PlannerPairing pair_planners(const SummaryGroup& group, const std::string& planner_a,
                             const Trials& trials_a, const std::string& planner_b,
                             const Trials& trials_b, const SummaryConfig& config) {
  using Key = std::tuple<std::string_view, std::string_view, std::int64_t>;
  const auto key = [](const RunRecord& r) {
    return Key(r.scenario_group, r.scenario, r.repetition);
  };
  std::map<Key, const RunRecord*> by_key;
  for (const RunRecord* trial : trials_b) {
    by_key.emplace(key(*trial), trial);
  }
  PlannerPairing pairing{group, planner_a, planner_b, 0, 0, 0, 0, {}};
  for (const RunRecord* trial : trials_a) {
    if (const auto other = by_key.find(key(*trial)); other != by_key.end()) {
      const int verdict = compare(*trial, *other->second, config.tie_tolerance);
      pairing.wins_a += verdict > 0;
      pairing.ties += verdict == 0;
      pairing.wins_b += verdict < 0;
      ++pairing.n;
    }
  }
  pairing.win_share_a = wilson_rate(pairing.wins_a, pairing.wins_a + pairing.wins_b);
  return pairing;
}

void summarise_groups(const Grouped& grouped, const SummaryConfig& config,
                      std::vector<PlannerSummary>& planners,
                      std::vector<PlannerPairing>& pairings) {
  for (const auto& [group, by_planner] : grouped) {
    for (auto a = by_planner.begin(); a != by_planner.end(); ++a) {
      planners.push_back(summarise_planner(group, a->first, a->second, config.bootstrap));
      for (auto b = std::next(a); b != by_planner.end(); ++b) {
        pairings.push_back(pair_planners(group, a->first, a->second, b->first, b->second, config));
      }
    }
  }
}

}  // namespace

Summary summarise(const std::vector<RunRecord>& records, const SummaryConfig& config) {
  Grouped groups;
  Grouped pooled;
  std::map<SummaryGroup, std::set<std::string>> families;
  for (const RunRecord& r : records) {
    const SummaryGroup all{"", r.vehicle, r.regulator, true};
    groups[{r.scenario_group, r.vehicle, r.regulator, false}][r.planner].push_back(&r);
    pooled[all][r.planner].push_back(&r);
    families[all].insert(r.scenario_group);
  }
  std::erase_if(pooled, [&](const auto& entry) { return families.at(entry.first).size() < 2; });
  Summary summary;
  summarise_groups(groups, config, summary.groups, summary.pairings);
  summarise_groups(pooled, config, summary.totals, summary.pairings);
  return summary;
}

}  // namespace voronaut
