#include "voronaut/reports/summary/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "voronaut/reports/summary/significance.h"

namespace voronaut {

namespace {

bool reached(const RunRecord& record) { return record.outcome == Outcome::goal_reached; }

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

Change share_change(const PairedCounts& counts, double tolerance) {
  Change change{paired_share_difference(counts.both, counts.gained, counts.lost, counts.n)};
  if (counts.n == 0) return change;
  change.p = mcnemar_exact(counts.gained, counts.lost);
  change.repetitions_needed = pairs_needed_of_share(
      static_cast<double>(counts.gained + counts.lost) / static_cast<double>(counts.n), tolerance);
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

// Of a planner whose pairs come one after another.
class PlannerComparison {
 public:
  PlannerComparison(const RunRecord& first, const ComparisonConfig& config)
      : config_(config), pairs_(config.statistics) {
    change_.group = {first.scenario_group, first.vehicle, first.regulator, false};
    change_.planner = first.planner;
  }

  bool holds(const RunRecord& r) const {
    return change_.planner == r.planner &&
           change_.group == SummaryGroup{r.scenario_group, r.vehicle, r.regulator, false};
  }

  void add(const RunRecord& before, const RunRecord& now) {
    pairs_.add(before, now);
    change_.changed += !config_.same_flight || !config_.same_flight(before, now);
    before_ += reached(before);
    now_ += reached(now);
    change_.gained += !reached(before) && reached(now);
    change_.lost += reached(before) && !reached(now);
  }

  PlannerChange change() {
    change_.n = pairs_.size();
    change_.reached_before = wilson_rate(before_, change_.n);
    change_.reached_now = wilson_rate(now_, change_.n);
    for (std::size_t i = 0; i < config_.statistics.size(); ++i) {
      const Statistic& statistic = *config_.statistics[i];
      Change& one = change_.changes.emplace_back(
          statistic.estimator == Estimator::rate
              ? share_change(pairs_.counts_of(i), config_.tolerance)
              : relative_change(statistic, pairs_.values_of(i), config_));
      one.repetitions_needed = std::ceil(one.repetitions_needed / pairs_.pairs_at_once());
    }
    return change_;
  }

 private:
  const ComparisonConfig& config_;
  PairedTrials pairs_;
  std::int64_t before_ = 0, now_ = 0;  // that reached the goal
  PlannerChange change_;
};

// The pairs that end differently, of very many those of the lowest repetitions.
class OutcomeChanges {
 public:
  void add(const RunRecord& before, const RunRecord& now) {
    if (before.outcome == now.outcome) return;
    ++n_;
    kept_.push_back({before.outcome, now});
    if (kept_.size() >= 2 * kOutcomeChangesMax) keep_lowest();
  }

  std::int64_t size() const { return n_; }

  std::vector<OutcomeChange> by_trial() {
    if (kept_.size() > kOutcomeChangesMax) keep_lowest();
    std::sort(kept_.begin(), kept_.end(), [](const OutcomeChange& a, const OutcomeChange& b) {
      return a.now.trial_id < b.now.trial_id;
    });
    return std::move(kept_);
  }

 private:
  void keep_lowest() {
    const auto earlier = [](const OutcomeChange& a, const OutcomeChange& b) {
      return std::tie(a.now.repetition, a.now.trial_id) <
             std::tie(b.now.repetition, b.now.trial_id);
    };
    std::nth_element(kept_.begin(), kept_.begin() + kOutcomeChangesMax, kept_.end(), earlier);
    kept_.resize(kOutcomeChangesMax);
  }

  std::int64_t n_ = 0;
  std::vector<OutcomeChange> kept_;
};

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

RunComparison compare_runs(const NextRecord& now, const NextRecord& before,
                           const ComparisonConfig& config) {
  RunComparison comparison;
  comparison.tolerance = config.tolerance;
  comparison.statistics = config.statistics;
  std::optional<PlannerComparison> planner;
  OutcomeChanges outcomes;
  const auto finish = [&] {
    if (!planner) return;
    comparison.changes.push_back(planner->change());
    comparison.changed += comparison.changes.back().changed;
  };
  const Unpaired alone = for_each_pair(before, now, [&](const RunRecord& was, const RunRecord& is) {
    if (!planner || !planner->holds(is)) {
      finish();
      planner.emplace(is, config);
    }
    planner->add(was, is);
    outcomes.add(was, is);
    ++comparison.pairs;
  });
  finish();
  comparison.only_here = alone.now;
  comparison.only_there = alone.before;
  comparison.ended_differently = outcomes.size();
  comparison.outcomes = outcomes.by_trial();
  judge(comparison);
  return comparison;
}

namespace {

NextRecord in_pairing_order(const std::vector<RunRecord>& records) {
  std::vector<const RunRecord*> order;
  for (const RunRecord& record : records) order.push_back(&record);
  std::sort(order.begin(), order.end(),
            [](const RunRecord* a, const RunRecord* b) { return before_in_pairing(*a, *b); });
  return [order = std::move(order), next = std::size_t{0}]() mutable {
    return next < order.size() ? std::optional(*order[next++]) : std::nullopt;
  };
}

}  // namespace

RunComparison compare_runs(const std::vector<RunRecord>& now, const std::vector<RunRecord>& before,
                           const ComparisonConfig& config) {
  return compare_runs(in_pairing_order(now), in_pairing_order(before), config);
}

}  // namespace voronaut
