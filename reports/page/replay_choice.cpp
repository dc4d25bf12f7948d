#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "voronaut/reports/page/html_report.h"

// Which trials deserve a replay where not all of them fit.
namespace voronaut {

namespace {

using Trials = std::vector<const RunRecord*>;
// Trials that can be drawn into one picture: one vehicle in one true world.
using SceneKey = std::tuple<std::string, std::string, std::string, std::string>;
// What a reader asks about: one planner in one scenario, with one vehicle.
using SampleKey = std::tuple<std::string, std::string, std::string, std::string>;

SceneKey scene_key(const RunRecord& r) { return {r.scenario, r.vehicle, r.regulator, r.world_id}; }

SampleKey sample_key(const RunRecord& r) { return {r.scenario, r.vehicle, r.regulator, r.planner}; }

bool failed(const RunRecord& r) { return entry_of(r.outcome).failure; }

bool earlier(const RunRecord* a, const RunRecord* b) {
  return std::tie(a->repetition, a->planner, a->trial_id) <
         std::tie(b->repetition, b->planner, b->trial_id);
}

// One trial of every planner in the first world of every scenario.
std::set<const RunRecord*> of_first_scenes(const Trials& in_order) {
  std::map<std::tuple<std::string, std::string, std::string>, std::string> first_world;
  std::set<SampleKey> seen;
  std::set<const RunRecord*> chosen;
  for (const RunRecord* r : in_order) {
    const auto& world =
        first_world.try_emplace({r->scenario, r->vehicle, r->regulator}, r->world_id).first->second;
    if (world == r->world_id && seen.insert(sample_key(*r)).second) {
      chosen.insert(r);
    }
  }
  return chosen;
}

// Of one planner in one scenario: one trial of every way of failing, and the best, the median and
// the worst of those that reached the goal.
void add_representatives(Trials trials, std::set<const RunRecord*>& chosen) {
  std::set<Outcome> ways;
  for (const RunRecord* r : trials) {
    if (failed(*r) && ways.insert(r->outcome).second) {
      chosen.insert(r);
    }
  }
  std::erase_if(trials, [](const RunRecord* r) { return failed(*r) || std::isnan(r->path_ratio); });
  if (trials.empty()) {
    return;
  }
  std::stable_sort(trials.begin(), trials.end(), [](const RunRecord* a, const RunRecord* b) {
    return a->path_ratio < b->path_ratio;
  });
  chosen.insert({trials.front(), trials[trials.size() / 2], trials.back()});
}

std::set<const RunRecord*> representatives(const Trials& in_order) {
  std::map<SampleKey, Trials> samples;
  for (const RunRecord* r : in_order) {
    samples[sample_key(*r)].push_back(r);
  }
  std::set<const RunRecord*> chosen;
  for (auto& [key, trials] : samples) {
    add_representatives(std::move(trials), chosen);
  }
  return chosen;
}

}  // namespace

std::vector<std::string> order_of_replays(const std::vector<RunRecord>& records) {
  Trials in_order;
  for (const RunRecord& record : records) {
    in_order.push_back(&record);
  }
  std::sort(in_order.begin(), in_order.end(), earlier);
  const std::set<const RunRecord*> first = of_first_scenes(in_order);
  const std::set<const RunRecord*> representative = representatives(in_order);
  std::set<SceneKey> worth_comparing;
  for (const RunRecord* r : representative) {
    worth_comparing.insert(scene_key(*r));
  }
  const auto rank = [&](const RunRecord* r) {
    if (first.contains(r)) return 0;
    if (representative.contains(r)) return 1;
    if (worth_comparing.contains(scene_key(*r))) return 2;
    return failed(*r) ? 3 : 4;
  };
  std::stable_sort(in_order.begin(), in_order.end(),
                   [&](const RunRecord* a, const RunRecord* b) { return rank(a) < rank(b); });
  std::vector<std::string> order;
  for (const RunRecord* r : in_order) {
    order.push_back(r->trial_id);
  }
  return order;
}

}  // namespace voronaut
