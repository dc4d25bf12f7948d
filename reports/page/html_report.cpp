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
#include "voronaut/reports/summary/summary_table.h"

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

namespace {

// Of very many trials those of the lowest repetitions: each planner has them in the same worlds.
std::vector<RunRecord> records_to_draw(const ResultStore& store, std::size_t trials_max) {
  std::vector<RunRecord> records;
  store.for_each_record([&](const RunRecord& record) { records.push_back(record); },
                        "repetition, trial_id LIMIT " + std::to_string(trials_max));
  std::sort(records.begin(), records.end(),
            [](const RunRecord& a, const RunRecord& b) { return a.trial_id < b.trial_id; });
  return records;
}

}  // namespace

ReportInput read_report_input(const ResultStore& store, std::string title,
                              std::string manifest_json, std::size_t max_trace_bytes,
                              std::size_t trials_max) {
  ReportInput input;
  input.title = std::move(title);
  input.manifest_json = std::move(manifest_json);
  {  // gone before the records to draw are there
    SummaryTable table;
    store.for_each_record([&](const RunRecord& record) { table.add(record); });
    input.summary = table.summarise();
    input.stored_trials = static_cast<std::size_t>(table.size());
  }
  input.records = records_to_draw(store, trials_max);
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
  if (input.trace_blobs.empty())
    for (const RunRecord& record : input.records) drawn_worlds.insert(record.world_id);
  input.worlds = store.worlds(
      kWorldsMax, [&](const std::string& world_id) { return drawn_worlds.contains(world_id); });
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
