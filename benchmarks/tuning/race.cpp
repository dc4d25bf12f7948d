#include "voronaut/benchmarks/tuning/race.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/reports/summary/comparison.h"

namespace voronaut {

namespace {

bool can_be_tuned_for(const Statistic& statistic) {
  const RecordColumn* column = column_of(statistic);
  return statistic.better != Better::neither &&
         (column == nullptr || column->kind != ColumnKind::measured);
}

// Less is better.
double cost_of(const Statistic& objective, const RunRecord& record) {
  constexpr double kWorst = std::numeric_limits<double>::infinity();
  if (objective.trials == TrialSet::goal_reached && record.outcome != Outcome::goal_reached)
    return kWorst;
  const double value = value_of(objective, record);
  if (std::isnan(value)) return kWorst;
  return objective.better == Better::more ? -value : value;
}

// From 0 for the least to 1 for the most; equal costs share the mean of their ranks.
std::vector<double> ranks_of(const std::vector<double>& costs) {
  std::vector<double> ranks(costs.size(), 0);
  if (costs.size() < 2) return ranks;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    double below = 0;
    for (std::size_t k = 0; k < costs.size(); ++k)
      below += costs[k] < costs[i] ? 1 : (k != i && costs[k] == costs[i] ? 0.5 : 0);
    ranks[i] = below / static_cast<double>(costs.size() - 1);
  }
  return ranks;
}

// What all candidates fly under equal conditions, and the world that it is in.
struct Block {
  std::tuple<std::string, std::int64_t> world;
  std::vector<const RunRecord*> rows;  // in the order of the candidates
  std::vector<double> scores;
};

std::vector<Block> blocks_of(const std::vector<std::string>& planners,
                             const std::vector<RunRecord>& records) {
  using Key = std::tuple<std::string, std::int64_t, std::string, std::string>;
  std::map<Key, Block> blocks;
  for (const RunRecord& record : records) {
    const auto at = std::find(planners.begin(), planners.end(), record.planner);
    if (at == planners.end()) continue;
    Block& block = blocks[{record.scenario, record.repetition, record.vehicle, record.regulator}];
    block.world = {record.scenario, record.repetition};
    block.rows.resize(planners.size(), nullptr);
    block.rows[static_cast<std::size_t>(at - planners.begin())] = &record;
  }
  std::vector<Block> all;
  for (auto& [key, block] : blocks)
    if (std::find(block.rows.begin(), block.rows.end(), nullptr) == block.rows.end())
      all.push_back(std::move(block));
  return all;
}

void score(Block& block, const std::vector<const Statistic*>& objectives) {
  block.scores.assign(block.rows.size(), 0);
  for (const Statistic* objective : objectives) {
    std::vector<double> costs;
    for (const RunRecord* row : block.rows) costs.push_back(cost_of(*objective, *row));
    const std::vector<double> ranks = ranks_of(costs);
    for (std::size_t i = 0; i < ranks.size(); ++i)
      block.scores[i] += ranks[i] / static_cast<double>(objectives.size());
  }
}

// Too few worlds say nothing: no interval then.
Estimate mean_over_worlds(const std::vector<Block>& blocks, const std::vector<double>& values) {
  ResampledUnits worlds;
  std::map<std::tuple<std::string, std::int64_t>, std::size_t> number;
  for (const Block& block : blocks)
    worlds.unit_of.push_back(number.emplace(block.world, number.size()).first->second);
  worlds.units = number.size();
  const auto mean = [&](const std::vector<std::uint32_t>& counts) {
    double sum = 0;
    double n = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += counts[i] * values[i];
      n += counts[i];
    }
    return n > 0 ? sum / n : kAbsent;
  };
  Estimate estimate = bootstrap_test(worlds, mean, {.resamples = 2000}).estimate;
  if (worlds.units < kFewestWorlds) estimate.interval = {};
  return estimate;
}

}  // namespace

const Statistic& objective(const std::string& name) {
  std::vector<std::string> names = {"success"};
  for (const Statistic& one : statistics()) {
    if (!can_be_tuned_for(one)) continue;
    if (name == one.name || (name == "success" && one.name == "goal_reached_share")) return one;
    names.emplace_back(one.name);
  }
  for (const Statistic& one : statistics())
    if (const RecordColumn* column = column_of(one);
        can_be_tuned_for(one) && column != nullptr && column->name == name)
      return one;
  throw std::invalid_argument("--for: nothing to tune for is called " + in_quotes(name) +
                              allowed_names(name, names));
}

std::vector<Standing> race(const std::vector<std::string>& planners,
                           const std::vector<const Statistic*>& objectives,
                           const std::vector<RunRecord>& records, std::size_t most) {
  std::vector<Block> blocks = blocks_of(planners, records);
  std::vector<double> scores(planners.size(), 0);
  for (Block& block : blocks) {
    score(block, objectives);
    for (std::size_t i = 0; i < scores.size(); ++i)
      scores[i] += block.scores[i] / static_cast<double>(blocks.size());
  }
  std::vector<std::size_t> order(planners.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return scores[a] < scores[b]; });
  std::vector<Standing> standings;
  for (const std::size_t i : order) {
    std::vector<double> behind;
    for (const Block& block : blocks)
      behind.push_back(block.scores[i] - block.scores[order.front()]);
    Standing& standing = standings.emplace_back();
    standing.planner = planners[i];
    standing.score = scores[i];
    standing.behind_leader = mean_over_worlds(blocks, behind);
    standing.kept = standings.size() <= most && !(standing.behind_leader.interval.low > 0);
  }
  return standings;
}

std::vector<Rung> rungs(std::size_t candidates, int repetitions) {
  std::vector<Rung> all;
  for (std::size_t n = candidates; n > 1; n = (n + 1) / 2) {
    all.push_back({n, 0});
    if (n == 2) break;
  }
  int of_rung = repetitions;
  for (auto rung = all.rbegin(); rung != all.rend(); ++rung) {
    rung->repetitions = of_rung;
    of_rung = std::max(1, (of_rung + 1) / 2);
  }
  return all;
}

}  // namespace voronaut
