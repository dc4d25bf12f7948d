#include "voronaut/reports/summary/comparison.h"

#include <map>
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

template <class Value>
Estimate median_change(const std::vector<Pair>& pairs, bool both_reached,
                       const BootstrapConfig& bootstrap, Value&& value) {
  std::vector<double> changes;
  for (const Pair& pair : pairs) {
    if (!both_reached || (reached(*pair.before) && reached(*pair.now))) {
      changes.push_back(relative_change(static_cast<double>(value(*pair.before)),
                                        static_cast<double>(value(*pair.now))));
    }
  }
  return quantile_estimate(std::move(changes), 0.5, bootstrap);
}

PlannerChange change_of(const SummaryGroup& group, const std::string& planner,
                        const std::vector<Pair>& pairs, const BootstrapConfig& bootstrap) {
  PlannerChange change;
  change.group = group;
  change.planner = planner;
  change.n = static_cast<std::int64_t>(pairs.size());
  std::int64_t reached_before = 0;
  std::int64_t reached_now = 0;
  std::vector<double> differences;
  for (const auto& [before, now] : pairs) {
    reached_before += reached(*before);
    reached_now += reached(*now);
    change.gained += !reached(*before) && reached(*now);
    change.lost += reached(*before) && !reached(*now);
    differences.push_back(static_cast<double>(reached(*now)) -
                          static_cast<double>(reached(*before)));
  }
  change.reached_before = wilson_rate(reached_before, change.n);
  change.reached_now = wilson_rate(reached_now, change.n);
  change.success_change = mean_estimate(std::move(differences), bootstrap);
  const auto median = [&](bool both_reached, auto&& value) {
    return median_change(pairs, both_reached, bootstrap, value);
  };
  change.path_ratio_change = median(true, [](const RunRecord& r) { return r.path_ratio; });
  change.duration_change = median(true, [](const RunRecord& r) { return r.duration_s; });
  change.state_checks_change = median(false, [](const RunRecord& r) { return r.state_checks; });
  change.planning_time_change =
      median(false, [](const RunRecord& r) { return r.planning_time_us_mean; });
  return change;
}

}  // namespace

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
