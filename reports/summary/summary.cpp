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

// Trials of one group by planner; std::map so that the order is that of the names.
using Grouped = std::map<SummaryGroup, std::map<std::string, Trials>, InNaturalOrder>;

PlannerSummary summarise_planner(const SummaryGroup& group, const std::string& planner,
                                 const Trials& trials, const BootstrapConfig& bootstrap) {
  PlannerSummary summary{
      group, planner, static_cast<std::int64_t>(trials.size()), outcome_counts(trials), {}};
  for (const Statistic& one : statistics())
    summary.estimates.push_back(estimate_of(one, trials, bootstrap));
  return summary;
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
  using TrialKey = std::tuple<std::string_view, std::string_view, std::int64_t>;
  const auto key = [](const RunRecord& r) {
    return TrialKey(r.scenario_group, r.scenario, r.repetition);
  };
  std::map<TrialKey, const RunRecord*> by_key;
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

const Estimate& PlannerSummary::of(std::string_view name) const {
  return estimates.at(static_cast<std::size_t>(&statistic(name) - statistics().data()));
}

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
