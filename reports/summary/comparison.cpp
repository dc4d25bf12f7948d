#include "voronaut/reports/summary/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "voronaut/reports/summary/significance.h"

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

// The values of a statistic of the pairs that both have it, and what is resampled of them.
struct PairedValues {
  std::vector<double> before, now;
  ResampledUnits units;
  bool over_worlds = false;

  std::size_t size() const { return now.size(); }
};

PairedValues paired_values(const Statistic& statistic, const std::vector<Pair>& pairs) {
  PairedValues values;
  std::map<std::string_view, std::size_t> worlds;
  for (const Pair& pair : pairs) {
    if (statistic.trials == TrialSet::goal_reached &&
        !(reached(*pair.before) && reached(*pair.now)))
      continue;
    const double before = value_of(statistic, *pair.before);
    const double now = value_of(statistic, *pair.now);
    if (std::isnan(before) || std::isnan(now)) continue;
    values.before.push_back(before);
    values.now.push_back(now);
    values.units.unit_of.push_back(worlds.emplace(pair.now->world_id, worlds.size()).first->second);
  }
  values.over_worlds = worlds.size() >= kFewestWorlds;
  if (!values.over_worlds) std::iota(values.units.unit_of.begin(), values.units.unit_of.end(), 0U);
  values.units.units = values.over_worlds ? worlds.size() : values.size();
  return values;
}

double relative_change(double before, double now) {
  return before > 0 ? now / before - 1.0 : kAbsent;
}

double mean_of(const std::vector<double>& values, const std::vector<std::uint32_t>& counts) {
  double sum = 0;
  double n = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += counts[i] * values[i];
    n += counts[i];
  }
  return n > 0 ? sum / n : kAbsent;
}

// Positions of values in ascending order, to look resampled counts up in.
class Ordered {
 public:
  explicit Ordered(const std::vector<double>& values) : order_(values.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    for (const std::size_t i : order_) sorted_.push_back(values[i]);
  }

  double quantile(const std::vector<std::uint32_t>& counts, double probability) const {
    std::vector<std::uint32_t> ordered;
    ordered.reserve(order_.size());
    for (const std::size_t i : order_) ordered.push_back(counts[i]);
    return quantile_of_counts(sorted_, ordered, probability);
  }

 private:
  std::vector<std::size_t> order_;
  std::vector<double> sorted_;
};

// The pairs of which nothing can be said in relation to before are left out.
PairedValues with_something_before(const PairedValues& all) {
  PairedValues kept;
  kept.over_worlds = all.over_worlds;
  std::map<std::size_t, std::size_t> units;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(all.before[i] > 0)) continue;
    kept.before.push_back(all.before[i]);
    kept.now.push_back(all.now[i]);
    kept.units.unit_of.push_back(units.emplace(all.units.unit_of[i], units.size()).first->second);
  }
  kept.units.units = units.size();
  return kept;
}

ResampledValue change_in(const Statistic& statistic, const PairedValues& values) {
  if (statistic.estimator == Estimator::mean)
    return [&values](const auto& counts) {
      return relative_change(mean_of(values.before, counts), mean_of(values.now, counts));
    };
  if (statistic.estimator == Estimator::median) {
    std::vector<double> relative;
    for (std::size_t i = 0; i < values.size(); ++i)
      relative.push_back(relative_change(values.before[i], values.now[i]));
    return
        [ordered = Ordered(relative)](const auto& counts) { return ordered.quantile(counts, 0.5); };
  }
  const double probability = statistic.estimator == Estimator::p95 ? 0.95 : 0.0;
  return [probability, before = Ordered(values.before),
          now = Ordered(values.now)](const auto& counts) {
    return relative_change(before.quantile(counts, probability), now.quantile(counts, probability));
  };
}

Change share_change(const PairedValues& values, double tolerance) {
  std::int64_t both = 0, gained = 0, lost = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    both += values.before[i] > 0 && values.now[i] > 0;
    gained += values.before[i] == 0 && values.now[i] > 0;
    lost += values.before[i] > 0 && values.now[i] == 0;
  }
  const auto n = static_cast<std::int64_t>(values.size());
  Change change{paired_share_difference(both, gained, lost, n)};
  if (n == 0) return change;
  change.p = mcnemar_exact(gained, lost);
  change.repetitions_needed =
      pairs_needed_of_share(static_cast<double>(gained + lost) / static_cast<double>(n), tolerance);
  return change;
}

// A bootstrap says nothing of the smallest value: it has no interval and no test.
Change relative_change(const Statistic& statistic, const PairedValues& all,
                       const ComparisonConfig& config) {
  const PairedValues values = with_something_before(all);
  BootstrapConfig bootstrap = config.bootstrap;
  constexpr std::size_t kMostDraws = 200'000'000;
  constexpr int kFewestResamples = 1000;
  const auto affordable = static_cast<int>(
      std::min<std::size_t>(kMostDraws / std::max<std::size_t>(values.size(), 1), 100'000));
  bootstrap.resamples = std::min(bootstrap.resamples, std::max(kFewestResamples, affordable));
  if (statistic.estimator == Estimator::smallest) bootstrap.resamples = 0;
  const TestedEstimate tested =
      bootstrap_test(values.units, change_in(statistic, values), bootstrap);
  Change change{tested.estimate};
  change.p = tested.p;
  change.over_worlds = values.over_worlds;
  change.repetitions_needed = pairs_needed(change, config.tolerance);
  return change;
}

// Pairs of a repetition.
double pairs_at_once(const std::vector<Pair>& pairs) {
  std::set<std::int64_t> repetitions;
  for (const Pair& pair : pairs) repetitions.insert(pair.now->repetition);
  return static_cast<double>(pairs.size()) / static_cast<double>(repetitions.size());
}

PlannerChange change_of(const SummaryGroup& group, const std::string& planner,
                        const std::vector<Pair>& pairs, const ComparisonConfig& config) {
  PlannerChange change;
  change.group = group;
  change.planner = planner;
  change.n = static_cast<std::int64_t>(pairs.size());
  std::int64_t reached_before = 0;
  std::int64_t reached_now = 0;
  for (const auto& [before, now] : pairs) {
    change.changed += !config.same_flight || !config.same_flight(*before, *now);
    reached_before += reached(*before);
    reached_now += reached(*now);
    change.gained += !reached(*before) && reached(*now);
    change.lost += reached(*before) && !reached(*now);
  }
  change.reached_before = wilson_rate(reached_before, change.n);
  change.reached_now = wilson_rate(reached_now, change.n);
  for (const Statistic* statistic : config.statistics) {
    const PairedValues values = paired_values(*statistic, pairs);
    Change& one = change.changes.emplace_back(statistic->estimator == Estimator::rate
                                                  ? share_change(values, config.tolerance)
                                                  : relative_change(*statistic, values, config));
    one.repetitions_needed = std::ceil(one.repetitions_needed / pairs_at_once(pairs));
  }
  return change;
}

ChangeVerdict verdict_of(const Change& change, Better better, double tolerance) {
  constexpr double kLevel = 0.05;
  if (better == Better::neither || !(change.p_holm < kLevel)) return ChangeVerdict::undecided;
  const bool more = change.interval.low > tolerance;
  if (!more && !(change.interval.high < -tolerance)) return ChangeVerdict::undecided;
  return more == (better == Better::more) ? ChangeVerdict::better : ChangeVerdict::worse;
}

void judge(RunComparison& comparison) {
  std::vector<double> p_values;
  for (const PlannerChange& planner : comparison.changes)
    for (const Change& change : planner.changes) p_values.push_back(change.p);
  const std::vector<double> corrected = holm_corrected(p_values);
  std::size_t at = 0;
  for (PlannerChange& planner : comparison.changes) {
    for (std::size_t i = 0; i < planner.changes.size(); ++i) {
      Change& change = planner.changes[i];
      change.p_holm = corrected[at++];
      change.verdict = verdict_of(change, comparison.statistics[i]->better, comparison.tolerance);
    }
  }
}

}  // namespace

const Change& PlannerChange::of(const RunComparison& comparison, std::string_view name) const {
  for (std::size_t i = 0; i < comparison.statistics.size(); ++i)
    if (comparison.statistics[i]->name == name) return changes.at(i);
  throw std::invalid_argument("'" + std::string(name) + "' is not compared");
}

bool RunComparison::worse() const {
  for (const PlannerChange& planner : changes)
    for (const Change& change : planner.changes)
      if (change.verdict == ChangeVerdict::worse) return true;
  return false;
}

RunComparison compare_runs(const std::vector<RunRecord>& now, const std::vector<RunRecord>& before,
                           const ComparisonConfig& config) {
  std::map<Key, const RunRecord*> partners;
  for (const RunRecord& record : before) {
    partners.emplace(key_of(record), &record);
  }
  RunComparison comparison;
  comparison.tolerance = config.tolerance;
  comparison.statistics = config.statistics;
  std::map<std::pair<SummaryGroup, std::string>, std::vector<Pair>> pairs;
  for (const RunRecord& record : now) {
    const auto partner = partners.find(key_of(record));
    if (partner == partners.end()) {
      ++comparison.only_here;
      continue;
    }
    ++comparison.pairs;
    const SummaryGroup group{record.scenario_group, record.vehicle, record.regulator, false};
    pairs[{group, record.planner}].push_back({partner->second, &record});
    if (partner->second->outcome != record.outcome) {
      comparison.outcomes.push_back({partner->second->outcome, record});
    }
  }
  comparison.only_there = static_cast<std::int64_t>(partners.size()) - comparison.pairs;
  for (const auto& [key, list] : pairs) {
    comparison.changes.push_back(change_of(key.first, key.second, list, config));
    comparison.changed += comparison.changes.back().changed;
  }
  judge(comparison);
  return comparison;
}

}  // namespace voronaut
