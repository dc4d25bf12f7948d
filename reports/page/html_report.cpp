#include "voronaut/reports/page/html_report.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "voronaut/reports/page/report_data.h"
#include "voronaut/reports/page/web_assets.h"
#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {

namespace {

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

std::string page_with(const std::string& title, const std::string& data_json) {
  const WebAssets assets = web_assets();
  return replace_markers(assets.template_html, {{"title", escaped_for_html(title)},
                                                {"style_hash", std::string(assets.style_hash)},
                                                {"script_hash", std::string(assets.script_hash)},
                                                {"style", std::string(assets.style_css)},
                                                {"script", std::string(assets.script_js)},
                                                {"data", escaped_for_script(data_json)}});
}

std::string html_report(const ReportInput& input) {
  return page_with(input.title, report_data_json(input));
}

void write_html_report(const ReportInput& input, const std::filesystem::path& file) {
  write_file_atomically(file, html_report(input));
}

}  // namespace voronaut
