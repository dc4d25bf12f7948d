#include "voronaut/reports/summary/comparison.h"

#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace voronaut {

namespace {

using Key =
    std::tuple<std::string, std::string, std::string, std::string, std::string, std::int64_t>;

Key key_of(const RunRecord& r) {
  return {r.scenario_group, r.scenario, r.vehicle, r.regulator, r.planner, r.repetition};
}

struct Pair {
  const RunRecord* before;
  const RunRecord* now;
};

bool reached(const RunRecord& record) { return record.outcome == Outcome::goal_reached; }

// NaN, which the estimates leave out, where there is nothing to compare with.
double relative_change(double before, double now) {
  return before > 0 ? now / before - 1.0 : kAbsent;
}

// NaN, which the estimates leave out, where one of the two has no value.
double change_of(const Statistic& statistic, const Pair& pair) {
  if (statistic.trials == TrialSet::goal_reached && !(reached(*pair.before) && reached(*pair.now)))
    return kAbsent;
  const double before = value_of(statistic, *pair.before);
  const double now = value_of(statistic, *pair.now);
  return statistic.estimator == Estimator::rate ? now - before : relative_change(before, now);
}

Estimate change_of(const Statistic& statistic, const std::vector<Pair>& pairs,
                   const BootstrapConfig& bootstrap) {
  std::vector<double> changes;
  changes.reserve(pairs.size());
  for (const Pair& pair : pairs) changes.push_back(change_of(statistic, pair));
  return statistic.estimator == Estimator::rate
             ? mean_estimate(std::move(changes), bootstrap)
             : quantile_estimate(std::move(changes), 0.5, bootstrap);
}

PlannerChange change_of(const SummaryGroup& group, const std::string& planner,
                        const std::vector<Pair>& pairs, const BootstrapConfig& bootstrap) {
  PlannerChange change;
  change.group = group;
  change.planner = planner;
  change.n = static_cast<std::int64_t>(pairs.size());
  std::int64_t reached_before = 0;
  std::int64_t reached_now = 0;
  for (const auto& [before, now] : pairs) {
    reached_before += reached(*before);
    reached_now += reached(*now);
    change.gained += !reached(*before) && reached(*now);
    change.lost += reached(*before) && !reached(*now);
  }
  change.reached_before = wilson_rate(reached_before, change.n);
  change.reached_now = wilson_rate(reached_now, change.n);
  for (const Statistic* statistic : statistics_shown(kComparison))
    change.changes.push_back(change_of(*statistic, pairs, bootstrap));
  return change;
}

}  // namespace

const Estimate& PlannerChange::of(std::string_view statistic) const {
  const auto compared = statistics_shown(kComparison);
  for (std::size_t i = 0; i < compared.size(); ++i)
    if (compared[i]->name == statistic) return changes.at(i);
  throw std::invalid_argument("'" + std::string(statistic) + "' is not compared");
}

RunComparison compare_runs(const std::vector<RunRecord>& now, const std::vector<RunRecord>& before,
                           const BootstrapConfig& bootstrap) {
  std::map<Key, const RunRecord*> partners;
  for (const RunRecord& record : before) {
    partners.emplace(key_of(record), &record);
  }
  RunComparison comparison;
  std::map<std::pair<SummaryGroup, std::string>, std::vector<Pair>> pairs;
  std::int64_t paired = 0;
  for (const RunRecord& record : now) {
    const auto partner = partners.find(key_of(record));
    if (partner == partners.end()) {
      ++comparison.only_here;
      continue;
    }
    ++paired;
    const SummaryGroup group{record.scenario_group, record.vehicle, record.regulator, false};
    pairs[{group, record.planner}].push_back({partner->second, &record});
    if (partner->second->outcome != record.outcome) {
      comparison.outcomes.push_back({partner->second->outcome, record});
    }
  }
  comparison.only_there = static_cast<std::int64_t>(partners.size()) - paired;
  for (const auto& [key, list] : pairs) {
    comparison.changes.push_back(change_of(key.first, key.second, list, bootstrap));
  }
  return comparison;
}

}  // namespace voronaut
