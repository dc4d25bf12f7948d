#include "voronaut/reports/page/report_data.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "voronaut/reports/encoding/deflate.h"
#include "voronaut/reports/encoding/json_text.h"
#include "voronaut/reports/record_columns.h"
#include "voronaut/reports/summary/comparison_text.h"
#include "voronaut/reports/summary/summary_text.h"
#include "voronaut/reports/trace/trace_json.h"

namespace voronaut {

namespace {

using nlohmann::json;

double seven_digits(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.7g", value);
  return std::strtod(buffer.data(), nullptr);
}

// A column of few distinct texts, each written once.
class TextColumn {
 public:
  void push(const std::string& text) {
    const auto [entry, added] = index_of_.try_emplace(text, index_of_.size());
    if (added) {
      texts_.push_back(text);
    }
    index_.push_back(entry->second);
  }
  json take() { return {{"texts", std::move(texts_)}, {"index", std::move(index_)}}; }

 private:
  std::map<std::string, std::size_t> index_of_;
  json texts_ = json::array();
  json index_ = json::array();
};

json numbers_to_json(const std::vector<RunRecord>& records, double RunRecord::*member) {
  json numbers = json::array();
  for (const RunRecord& record : records) {
    const double value = record.*member;
    numbers.push_back(std::isfinite(value) ? json(seven_digits(value)) : json(nullptr));
  }
  return numbers;
}

json trials_to_json(const std::vector<RunRecord>& records) {
  json columns = json::object();
  for (const RecordColumn& column : record_columns()) {
    if (column.name == "state_digest") continue;
    json& written = columns[std::string(column.name)];
    if (const auto* number = std::get_if<double RunRecord::*>(&column.member)) {
      written = numbers_to_json(records, *number);
      continue;
    }
    TextColumn texts;  // integers too: a seed has more digits than a double
    for (const RunRecord& record : records) texts.push(cell_text(record, column));
    written = texts.take();
  }
  return columns;
}

json columns_to_json() {
  json columns = json::object();
  for (const RecordColumn& column : record_columns())
    columns[std::string(column.name)] = {{"unit", column.unit}, {"about", column.about}};
  return columns;
}

json outcomes_to_json() {
  json outcomes = json::array();
  for (const OutcomeEntry& entry : kOutcomes)
    outcomes.push_back({{"name", entry.name},
                        {"words", entry.words},
                        {"sign", entry.sign},
                        {"colour", entry.colour},
                        {"colour_on_dark", entry.colour_on_dark},
                        {"failure", entry.failure},
                        {"meaning", entry.meaning}});
  return outcomes;
}

json manifest_to_json(const std::string& text) {
  if (text.empty()) {
    return json::object();
  }
  json manifest = json::parse(text, nullptr, false);
  return manifest.is_discarded() ? json(text) : manifest;
}

}  // namespace

std::string report_data_json(const ReportInput& input) {
  json out;
  out["title"] = input.title;
  out["manifest"] = manifest_to_json(input.manifest_json);
  out["columns"] = columns_to_json();
  out["outcomes"] = outcomes_to_json();
  out["summary"] = json::parse(summary_json(input.summary));
  out["trials"] = trials_to_json(input.records);
  out["worlds"] = json::array();
  for (const TraceWorld& world : input.worlds) {
    out["worlds"].push_back(json::parse(world_to_json(world)));
  }
  out["traces"] = json::object();
  for (const auto& [trial_id, blob] : input.trace_blobs) {
    out["traces"][trial_id] = base64(blob);
  }
  out["stored_traces"] = std::max(input.stored_traces, input.trace_blobs.size());
  out["stored_trials"] = std::max(input.stored_trials, input.records.size());
  out["folder"] = input.folder.empty() ? "DIR" : input.folder;
  out["comparison"] =
      input.comparison ? json::parse(comparison_json(*input.comparison)) : json(nullptr);
  out["published"] = input.published ? json::parse(barn_json(*input.published)) : json(nullptr);
  out["mapping"] = input.mapping_json.empty() ? json(nullptr) : json::parse(input.mapping_json);
  return json_text(out);
}

std::string escaped_for_script(std::string_view json_text) {
  std::string out;
  out.reserve(json_text.size());
  for (std::size_t i = 0; i < json_text.size(); ++i) {
    if (json_text[i] == '<') {
      out += "\\u003c";
    } else if (json_text.substr(i, 3) == "\xe2\x80\xa8") {
      out += "\\u2028";
      i += 2;
    } else if (json_text.substr(i, 3) == "\xe2\x80\xa9") {
      out += "\\u2029";
      i += 2;
    } else {
      out += json_text[i];
    }
  }
  return out;
}

std::string escaped_for_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace voronaut
