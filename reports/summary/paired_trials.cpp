#include "voronaut/reports/summary/paired_trials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>

namespace voronaut {

namespace {

auto pairing_key(const RunRecord& r) {
  return std::tie(r.scenario_group, r.vehicle, r.regulator, r.planner, r.scenario, r.repetition);
}

bool arrived(const RunRecord& record) { return record.outcome == Outcome::goal_reached; }

}  // namespace

bool before_in_pairing(const RunRecord& a, const RunRecord& b) {
  if (pairing_key(a) != pairing_key(b)) return pairing_key(a) < pairing_key(b);
  return a.trial_id < b.trial_id;
}

Unpaired for_each_pair(
    const NextRecord& next_before, const NextRecord& next_now,
    const std::function<void(const RunRecord& before, const RunRecord& now)>& use) {
  Unpaired alone;
  std::optional<RunRecord> before = next_before();
  bool has_partner = false;
  const auto pass = [&] {
    alone.before += has_partner ? 0 : 1;
    has_partner = false;
    std::optional<RunRecord> next = next_before();
    while (next && pairing_key(*next) == pairing_key(*before)) next = next_before();
    before = std::move(next);
  };
  while (const std::optional<RunRecord> now = next_now()) {
    while (before && pairing_key(*before) < pairing_key(*now)) pass();
    if (!before || pairing_key(*before) != pairing_key(*now)) {
      ++alone.now;
      continue;
    }
    has_partner = true;
    use(*before, *now);
  }
  while (before) pass();
  return alone;
}

PairedTrials::PairedTrials(const std::vector<const Statistic*>& statistics)
    : statistics_(statistics), rates_(statistics.size()) {
  for (const Statistic* statistic : statistics) {
    const auto same = [&](const Column& column) { return column.value == statistic->value; };
    const auto found = std::find_if(columns_.begin(), columns_.end(), same);
    column_of_.push_back(static_cast<std::size_t>(found - columns_.begin()));
    if (found == columns_.end() && statistic->estimator != Estimator::rate)
      columns_.push_back({statistic->value, {}, {}});
  }
}

void PairedTrials::add(const RunRecord& before, const RunRecord& now) {
  const bool both_reached = arrived(before) && arrived(now);
  both_reached_.push_back(both_reached);
  const auto world = worlds_.try_emplace(std::hash<std::string>{}(now.world_id),
                                         static_cast<std::uint32_t>(worlds_.size()));
  world_of_.push_back(world.first->second);
  repetitions_.push_back(now.repetition);
  for (std::size_t i = 0; i < statistics_.size(); ++i) {
    const Statistic& statistic = *statistics_[i];
    if (statistic.estimator != Estimator::rate) continue;
    if (statistic.trials == TrialSet::goal_reached && !both_reached) continue;
    const bool held_before = value_of(statistic, before) > 0;
    const bool holds_now = value_of(statistic, now) > 0;
    PairedCounts& counts = rates_[i];
    ++counts.n;
    counts.both += held_before && holds_now;
    counts.gained += !held_before && holds_now;
    counts.lost += held_before && !holds_now;
  }
  for (Column& column : columns_) {
    column.before.push_back(value_of(column.value, before));
    column.now.push_back(value_of(column.value, now));
  }
}

PairedValues PairedTrials::values_of(std::size_t statistic) const {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const Column& column = columns_.at(column_of_[statistic]);
  const bool of_reached = statistics_[statistic]->trials == TrialSet::goal_reached;
  PairedValues values;
  std::vector<std::uint32_t> unit_of_world(worlds_.size(), kNone);
  std::uint32_t units = 0;
  for (std::size_t i = 0; i < world_of_.size(); ++i) {
    if ((of_reached && !both_reached_[i]) || std::isnan(column.before[i]) ||
        std::isnan(column.now[i]))
      continue;
    values.before.push_back(column.before[i]);
    values.now.push_back(column.now[i]);
    std::uint32_t& unit = unit_of_world[world_of_[i]];
    if (unit == kNone) unit = units++;
    values.units.unit_of.push_back(unit);
  }
  values.over_worlds = units >= kFewestWorlds;
  if (!values.over_worlds) std::iota(values.units.unit_of.begin(), values.units.unit_of.end(), 0U);
  values.units.units = values.over_worlds ? units : values.size();
  return values;
}

double PairedTrials::pairs_at_once() const {
  std::vector<std::int64_t> repetitions(repetitions_.begin(), repetitions_.end());
  std::sort(repetitions.begin(), repetitions.end());
  const auto distinct = std::unique(repetitions.begin(), repetitions.end()) - repetitions.begin();
  return static_cast<double>(size()) / static_cast<double>(distinct);
}

}  // namespace voronaut
