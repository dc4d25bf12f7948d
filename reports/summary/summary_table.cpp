#include "voronaut/reports/summary/summary_table.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "voronaut/reports/summary/natural_order.h"
#include "voronaut/reports/summary/ranks.h"

namespace voronaut {

void SummaryTable::PlannerTrials::add(const PlannerTrials& other) {
  n += other.n;
  for (std::size_t i = 0; i < outcomes.size(); ++i) outcomes[i] += other.outcomes[i];
  values.resize(other.values.size());
  successes.resize(other.successes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].insert(values[i].end(), other.values[i].begin(), other.values[i].end());
    successes[i] += other.successes[i];
  }
  scenes.insert(scenes.end(), other.scenes.begin(), other.scenes.end());
}

bool SummaryTable::InNaturalOrder::operator()(const SummaryGroup& a, const SummaryGroup& b) const {
  if (natural_less(a.scenario_group, b.scenario_group)) return true;
  return !natural_less(b.scenario_group, a.scenario_group) && a < b;
}

void SummaryTable::add(const RunRecord& record) {
  const SummaryGroup group{record.scenario_group, record.vehicle, record.regulator, false};
  PlannerTrials& trials = groups_[group][record.planner];
  const auto all = statistics();
  trials.values.resize(all.size());
  trials.successes.resize(all.size());
  const bool reached = record.outcome == Outcome::goal_reached;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].trials == TrialSet::goal_reached && !reached) continue;
    const double value = value_of(all[i], record);
    if (all[i].estimator == Estimator::rate) {
      trials.successes[i] += std::llround(value);
    } else if (!std::isnan(value)) {  // the estimates leave it out
      trials.values[i].push_back(value);
    }
  }
  ++trials.n;
  ++trials.outcomes[static_cast<std::size_t>(record.outcome)];
  const auto scenario = scenarios_
                            .try_emplace({record.scenario_group, record.scenario},
                                         static_cast<std::uint32_t>(scenarios_.size()))
                            .first->second;
  trials.scenes.push_back({scenario, reached, record.repetition, record.path_ratio});
  ++size_;
}

PlannerSummary SummaryTable::summary_of(const SummaryGroup& group, const std::string& planner,
                                        const PlannerTrials& trials,
                                        const BootstrapConfig& bootstrap) {
  PlannerSummary summary;
  summary.group = group;
  summary.planner = planner;
  summary.n = trials.n;
  summary.outcomes = trials.outcomes;
  const auto all = statistics();
  for (std::size_t i = 0; i < all.size(); ++i)
    summary.estimates.push_back(
        all[i].estimator == Estimator::rate
            ? wilson_rate(trials.successes[i], trials.n)
            : estimate_of(all[i],
                          std::vector<double>(trials.values[i].begin(), trials.values[i].end()),
                          bootstrap));
  return summary;
}

// 1 if a is better, -1 if b is, 0 for a tie.
int SummaryTable::compare(const Scene& a, const Scene& b, double tie_tolerance) {
  if (a.reached != b.reached) return a.reached ? 1 : -1;
  // Either may be absent, where no shortest path is known: no verdict then.
  if (!a.reached || !(std::abs(a.path_ratio - b.path_ratio) >
                      tie_tolerance * std::min(a.path_ratio, b.path_ratio)))
    return 0;
  return a.path_ratio < b.path_ratio ? 1 : -1;
}

PlannerPairing SummaryTable::pairing_of(const SummaryGroup& group, const std::string& planner_a,
                                        const PlannerTrials& a, const std::string& planner_b,
                                        const PlannerTrials& b, double tie_tolerance) {
  std::vector<Scene> others(b.scenes.begin(), b.scenes.end());
  const auto before = [](const Scene& one, const Scene& other) { return one.before(other); };
  std::stable_sort(others.begin(), others.end(), before);
  PlannerPairing pairing;
  pairing.group = group;
  pairing.planner_a = planner_a;
  pairing.planner_b = planner_b;
  for (const Scene& scene : a.scenes) {
    const auto other = std::lower_bound(others.begin(), others.end(), scene, before);
    if (other == others.end() || scene.before(*other)) continue;
    const int verdict = compare(scene, *other, tie_tolerance);
    pairing.wins_a += verdict > 0;
    pairing.ties += verdict == 0;
    pairing.wins_b += verdict < 0;
    pairing.only_a += scene.reached && !other->reached;
    pairing.only_b += !scene.reached && other->reached;
    ++pairing.n;
  }
  pairing.win_share_a = wilson_rate(pairing.wins_a, pairing.wins_a + pairing.wins_b);
  return pairing;
}

void SummaryTable::summarise_group(const SummaryGroup& group, const Planners& planners,
                                   const SummaryConfig& config,
                                   std::vector<PlannerSummary>& summaries,
                                   std::vector<PlannerPairing>& pairings) {
  const std::size_t first_summary = summaries.size();
  const std::size_t first_pairing = pairings.size();
  for (auto a = planners.begin(); a != planners.end(); ++a) {
    summaries.push_back(summary_of(group, a->first, a->second, config.bootstrap));
    for (auto b = std::next(a); b != planners.end(); ++b)
      pairings.push_back(
          pairing_of(group, a->first, a->second, b->first, b->second, config.tie_tolerance));
  }
  rank_planners(std::span(summaries).subspan(first_summary),
                std::span(pairings).subspan(first_pairing));
}

Summary SummaryTable::summarise(const SummaryConfig& config) const {
  Summary summary;
  std::map<SummaryGroup, std::vector<const Planners*>> families;
  for (const auto& [group, planners] : groups_) {
    summarise_group(group, planners, config, summary.groups, summary.pairings);
    families[{"", group.vehicle, group.regulator, true}].push_back(&planners);
  }
  for (const auto& [all, members] : families) {
    if (members.size() < 2) continue;
    Planners pooled;
    for (const Planners* planners : members)
      for (const auto& [name, trials] : *planners) pooled[name].add(trials);
    summarise_group(all, pooled, config, summary.totals, summary.pairings);
  }
  return summary;
}

}  // namespace voronaut
