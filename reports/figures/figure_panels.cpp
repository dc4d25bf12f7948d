#include "voronaut/reports/figures/figure_panels.h"

#include <algorithm>

namespace voronaut {

namespace {

template <class Value>
Value stored(std::optional<Value> value, const std::string& trial_id, const char* what) {
  if (!value) {
    throw StoreError("trial " + trial_id + ": no " + what + " is stored");
  }
  return *std::move(value);
}

}  // namespace

std::vector<FigurePanel> figure_panels(const ResultStore& store,
                                       const std::vector<std::string>& trial_ids) {
  const std::vector<TraceWorld> worlds = store.worlds();
  std::vector<FigurePanel> panels;
  for (const std::string& trial_id : trial_ids) {
    const RunRecord record = stored(store.record(trial_id), trial_id, "such trial");
    const auto world = std::find_if(worlds.begin(), worlds.end(), [&](const TraceWorld& w) {
      return w.world_id == record.world_id;
    });
    if (world == worlds.end()) {
      throw StoreError("trial " + trial_id + ": no world is stored");
    }
    auto panel = std::find_if(panels.begin(), panels.end(), [&](const FigurePanel& p) {
      return p.world.world_id == record.world_id;
    });
    if (panel == panels.end()) {
      panel = panels.insert(panels.end(), FigurePanel{record.scenario, *world, {}});
    }
    panel->tracks.push_back(
        {record.planner, record.outcome, stored(store.trace(trial_id), trial_id, "trace")});
  }
  return panels;
}

}  // namespace voronaut
