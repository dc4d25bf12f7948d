#include "voronaut/reports/page/html_report.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "voronaut/reports/page/report_data.h"
#include "voronaut/reports/page/web_assets.h"
#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {

namespace {

// Trials that can be drawn into one picture: one vehicle in one true world.
using Scene = std::vector<const RunRecord*>;

std::vector<Scene> scenes_of(const std::vector<RunRecord>& records) {
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  std::map<Key, Scene> scenes;
  for (const RunRecord& r : records) {
    scenes[{r.scenario, r.vehicle, r.regulator, r.world_id}].push_back(&r);
  }
  std::vector<Scene> list;
  for (auto& [key, scene] : scenes) {
    std::sort(scene.begin(), scene.end(), [](const RunRecord* a, const RunRecord* b) {
      return std::tie(a->repetition, a->planner, a->trial_id) <
             std::tie(b->repetition, b->planner, b->trial_id);
    });
    list.push_back(std::move(scene));
  }
  return list;
}

bool failed(const RunRecord* trial) { return trial->outcome != Outcome::goal_reached; }

// How many scenes of the same scenario come before this one, those with the lowest repetition
// first.
std::vector<std::size_t> turn_of_scenes(const std::vector<Scene>& scenes) {
  std::vector<std::size_t> order(scenes.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scenes[a].front()->repetition < scenes[b].front()->repetition;
  });
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> seen;
  std::vector<std::size_t> turn(scenes.size());
  for (const std::size_t i : order) {
    const RunRecord& r = *scenes[i].front();
    turn[i] = seen[{r.scenario, r.vehicle, r.regulator}]++;
  }
  return turn;
}

std::string replace_markers(std::string_view text,
                            const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string out;
  while (!text.empty()) {
    const std::size_t open = text.find("{{");
    out += text.substr(0, open);
    if (open == std::string_view::npos) {
      break;
    }
    const std::size_t close = text.find("}}", open);
    const std::string_view name = text.substr(open + 2, close - open - 2);
    for (const auto& [key, value] : values) {
      out += key == name ? std::string_view(value) : std::string_view();
    }
    text.remove_prefix(close + 2);
  }
  return out;
}

}  // namespace

std::vector<std::string> order_of_replays(const std::vector<RunRecord>& records) {
  const std::vector<Scene> scenes = scenes_of(records);
  const std::vector<std::size_t> turn = turn_of_scenes(scenes);
  // Round 0: the first scene of each scenario, one trial per planner. 1: scenes with a failure.
  // 2: all other scenes, one trial per planner. 3: further failures. 4: everything else.
  std::vector<std::tuple<int, std::size_t, std::size_t, std::size_t, std::string>> ranked;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const bool any_failure = std::any_of(scenes[i].begin(), scenes[i].end(), failed);
    std::set<std::string_view> planners;
    for (std::size_t k = 0; k < scenes[i].size(); ++k) {
      const bool first_of_planner = planners.insert(scenes[i][k]->planner).second;
      const int scene_round = turn[i] == 0 ? 0 : (any_failure ? 1 : 2);
      const int round = first_of_planner ? scene_round : (failed(scenes[i][k]) ? 3 : 4);
      ranked.emplace_back(round, turn[i], i, k, scenes[i][k]->trial_id);
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> order;
  for (auto& entry : ranked) {
    order.push_back(std::move(std::get<4>(entry)));
  }
  return order;
}

ReportInput read_report_input(const ResultStore& store, std::string title,
                              std::string manifest_json, std::size_t max_trace_bytes) {
  ReportInput input;
  input.title = std::move(title);
  input.manifest_json = std::move(manifest_json);
  input.records = store.records();
  input.summary = summarise(input.records);
  const auto sizes = store.trace_sizes();
  input.stored_traces = sizes.size();
  std::map<std::string_view, std::string_view> world_of;
  for (const RunRecord& record : input.records) {
    world_of[record.trial_id] = record.world_id;
  }
  std::size_t used = 0;
  std::set<std::string_view> drawn_worlds;
  for (const std::string& trial_id : order_of_replays(input.records)) {
    const auto stored = sizes.find(trial_id);
    if (stored == sizes.end()) {
      continue;
    }
    const std::size_t size = (stored->second + 2) / 3 * 4;  // as base64
    if (used + size <= max_trace_bytes) {
      used += size;
      drawn_worlds.insert(world_of.at(trial_id));
      input.trace_blobs.emplace(trial_id, store.trace_blob(trial_id).value());
    }
  }
  input.worlds = store.worlds();
  std::erase_if(input.worlds, [&](const TraceWorld& world) {
    return !input.trace_blobs.empty() && !drawn_worlds.contains(world.world_id);
  });
  return input;
}

std::string html_report(const ReportInput& input) {
  const WebAssets assets = web_assets();
  return replace_markers(assets.template_html,
                         {{"title", escaped_for_html(input.title)},
                          {"style_hash", std::string(assets.style_hash)},
                          {"script_hash", std::string(assets.script_hash)},
                          {"style", std::string(assets.style_css)},
                          {"script", std::string(assets.script_js)},
                          {"data", escaped_for_script(report_data_json(input))}});
}

void write_html_report(const ReportInput& input, const std::filesystem::path& file) {
  write_file_atomically(file, html_report(input));
}

}  // namespace voronaut
