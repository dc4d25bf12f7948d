#include "voronaut/reports/summary/published_results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "voronaut/reports/summary/significance.h"
#include "voronaut/reports/summary/statistic_text.h"
#include "voronaut/reports/summary/text_table.h"

namespace voronaut {

namespace {

using ByWorld = std::map<std::string, PublishedWorld>;

// Sums over the runs of a world; score and time are sums until means_of().
void count(PublishedWorld& world, const RunRecord& record) {
  ++world.runs;
  world.score = (world.runs == 1 ? 0 : world.score) + record.barn_score;
  if (record.outcome == Outcome::collision) ++world.collisions;
  if (record.outcome != Outcome::goal_reached) return;
  ++world.successes;
  world.time_s = (world.successes == 1 ? 0 : world.time_s) + record.barn_time_s;
}

using Entrant = std::pair<std::string, std::string>;  // vehicle (empty: theirs), name

std::map<Entrant, ByWorld> entrants_of(const std::vector<RunRecord>& records,
                                       const std::vector<PublishedMethod>& methods) {
  std::map<Entrant, ByWorld> entrants;
  for (const PublishedMethod& method : methods)
    for (const PublishedWorld& world : method.worlds)
      entrants[{"", method.name}][world.scenario] = world;
  for (const RunRecord& record : records) {
    if (std::isnan(record.barn_score)) continue;
    count(entrants[{record.vehicle, record.planner}][record.scenario], record);
  }
  for (auto& [entrant, worlds] : entrants) {
    if (entrant.first.empty()) continue;
    for (auto& [scenario, world] : worlds) {
      world.score /= static_cast<double>(world.runs);
      if (world.successes > 0) world.time_s /= static_cast<double>(world.successes);
    }
  }
  return entrants;
}

std::set<std::string> met_by_all(const std::map<Entrant, ByWorld>& entrants) {
  std::set<std::string> met;
  if (entrants.empty()) return met;
  for (const auto& met_by_first : entrants.begin()->second) {
    const std::string& scenario = met_by_first.first;
    if (std::ranges::all_of(entrants, [&](const auto& e) { return e.second.contains(scenario); }))
      met.insert(scenario);
  }
  return met;
}

BarnStanding standing_of(const Entrant& entrant, const ByWorld& worlds,
                         const std::set<std::string>& met, const BootstrapConfig& bootstrap) {
  BarnStanding standing;
  standing.name = entrant.second;
  standing.vehicle = entrant.first;
  std::int64_t runs = 0, successes = 0, collisions = 0;
  std::vector<double> scores, times_s;
  for (const std::string& scenario : met) {
    const PublishedWorld& world = worlds.at(scenario);
    runs += world.runs;
    successes += world.successes;
    collisions += world.collisions;
    scores.push_back(world.score);
    times_s.push_back(world.time_s);
  }
  standing.worlds = static_cast<std::int64_t>(met.size());
  standing.reached = wilson_rate(successes, runs);
  standing.collided = wilson_rate(collisions, runs);
  standing.score = mean_estimate(scores, bootstrap);
  standing.time_s = mean_estimate(times_s, bootstrap);
  return standing;
}

BarnDifference difference_of(const Entrant& ours, const Entrant& theirs, const ByWorld& our_worlds,
                             const ByWorld& their_worlds, const std::set<std::string>& met,
                             const BootstrapConfig& bootstrap) {
  std::vector<double> differences;
  for (const std::string& scenario : met)
    differences.push_back(our_worlds.at(scenario).score - their_worlds.at(scenario).score);
  ResampledUnits units;
  units.units = differences.size();
  for (std::size_t i = 0; i < differences.size(); ++i) units.unit_of.push_back(i);
  const auto mean_of = [&](const std::vector<std::uint32_t>& counts) {
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) sum += counts[i] * differences[i];
    return sum / static_cast<double>(counts.size());
  };
  const TestedEstimate tested = bootstrap_test(units, mean_of, bootstrap);
  BarnDifference difference;
  difference.planner = ours.second;
  difference.vehicle = ours.first;
  difference.method = theirs.second;
  difference.worlds = static_cast<std::int64_t>(met.size());
  difference.score = tested.estimate;
  if (differences.size() < kFewestResampled) {
    std::ranges::sort(differences);
    difference.score.too_few = differences;
  }
  difference.p = tested.p;
  return difference;
}

std::string with_spread(const Estimate& estimate, int digits) {
  return fixed(estimate.value, digits) + spread_text(estimate, digits);
}

std::string percent_with_interval(Estimate rate) {
  for (double* share : {&rate.value, &rate.interval.low, &rate.interval.high}) *share *= 100;
  return with_spread(rate, 1);
}

TextTable standings_table(const BarnComparison& comparison) {
  TextTable table{{{"planner", TextTable::Align::left},
                   {"vehicle", TextTable::Align::left},
                   {"runs"},
                   {"arrived %"},
                   {"collided %"},
                   {"score"},
                   {"time s"}},
                  {}};
  for (const BarnStanding& one : comparison.standings)
    table.rows.push_back({printable(one.name),
                          one.vehicle.empty() ? "published" : printable(one.vehicle),
                          std::to_string(one.reached.n), percent_with_interval(one.reached),
                          percent_with_interval(one.collided), with_spread(one.score, 3),
                          with_spread(one.time_s, 1)});
  return table;
}

TextTable differences_table(const BarnComparison& comparison) {
  TextTable table{{{"planner", TextTable::Align::left},
                   {"vehicle", TextTable::Align::left},
                   {"against", TextTable::Align::left},
                   {"score, difference"},
                   {"p (Holm)"}},
                  {}};
  for (const BarnDifference& one : comparison.differences)
    table.rows.push_back({printable(one.planner), printable(one.vehicle), printable(one.method),
                          with_spread(one.score, 3),
                          one.p_holm < 0.0001 ? "< 0.0001" : fixed(one.p_holm, 4)});
  return table;
}

std::string over_worlds(const BarnComparison& comparison) {
  return "Over the " + std::to_string(comparison.worlds) +
         " worlds that all have met; shares over runs, score and time over the worlds' means. "
         "Brackets are 95 % intervals: Wilson's of shares, a bootstrap over worlds of the rest. "
         "Differences are paired by world.\n";
}

}  // namespace

BarnComparison beside_published(const std::vector<RunRecord>& records,
                                const std::vector<PublishedMethod>& methods,
                                const BootstrapConfig& bootstrap) {
  const auto entrants = entrants_of(records, methods);
  const std::set<std::string> met = met_by_all(entrants);
  BarnComparison comparison;
  comparison.worlds = static_cast<std::int64_t>(met.size());
  if (met.empty()) return comparison;
  for (const auto& [entrant, worlds] : entrants)
    comparison.standings.push_back(standing_of(entrant, worlds, met, bootstrap));
  std::ranges::stable_sort(comparison.standings, std::ranges::greater{},
                           [](const BarnStanding& one) { return one.score.value; });
  std::vector<double> p_values;
  for (const auto& [ours, our_worlds] : entrants) {
    if (ours.first.empty()) continue;
    for (const auto& [theirs, their_worlds] : entrants) {
      if (!theirs.first.empty()) continue;
      comparison.differences.push_back(
          difference_of(ours, theirs, our_worlds, their_worlds, met, bootstrap));
      p_values.push_back(comparison.differences.back().p);
    }
  }
  const std::vector<double> corrected = holm_corrected(p_values);
  for (std::size_t i = 0; i < corrected.size(); ++i)
    comparison.differences[i].p_holm = corrected[i];
  return comparison;
}

std::string barn_text(const BarnComparison& comparison) {
  return standings_table(comparison).aligned() + "\n" + differences_table(comparison).aligned() +
         "\n" + over_worlds(comparison);
}

std::string barn_markdown(const BarnComparison& comparison) {
  return standings_table(comparison).markdown() + "\n" + differences_table(comparison).markdown() +
         "\n" + over_worlds(comparison);
}

}  // namespace voronaut
