#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/store/store.h"
#include "voronaut/reports/summary/comparison.h"
#include "voronaut/reports/summary/published_results.h"
#include "voronaut/reports/summary/summary.h"
#include "voronaut/reports/trace/trace.h"

// One HTML file that works offline and asks nobody for anything: its content security policy allows
// the one script and the one style sheet it carries, by their hashes.
namespace voronaut {

// A trial takes about 300 bytes of the page, which is to stay below 20 MB.
inline constexpr std::size_t kReportTrialsMax = 20'000;
inline constexpr std::size_t kWorldsMax = 2000;

struct ReportInput {
  std::string title;
  std::string manifest_json;       // version, commit, machine ...: shown as it is; may be empty
  std::vector<RunRecord> records;  // that its plots and tables are of
  std::size_t stored_trials = 0;   // how many there were, all of them in the summary
  Summary summary;
  std::vector<TraceWorld> worlds;
  std::map<std::string, std::string> trace_blobs;  // by trial_id, as compress_trace makes them
  std::size_t stored_traces = 0;                   // how many there were to choose from
  std::string folder = {};  // where the run lies, for the command that repeats a trial
  std::optional<RunComparison> comparison = {};  // against another run
  std::optional<BarnComparison> published = {};  // beside what others published
  std::string mapping_json = {};  // mapping_data_json() of microbenchmarks beside it; empty: none
};

// What a store holds. The summary is over all trials; plots and tables of single ones are over
// `trials_max` of them, those of the lowest repetitions, and the report says so. If its traces take
// more than `max_trace_bytes` in the report, representative ones are kept (choose_replays) and the
// report says so.
ReportInput read_report_input(const ResultStore& store, std::string title,
                              std::string manifest_json,
                              std::size_t max_trace_bytes = std::size_t{11} << 20,
                              std::size_t trials_max = kReportTrialsMax);

// Trials in the order in which they deserve a replay: first, for each scenario in turn, one world
// with a trial of every planner; then, for each planner and scenario, one trial of every way of
// failing and the best, median and worst path ratio; then trials in the worlds of these; then what
// is left, failures first. O(n log n) for n records.
std::vector<std::string> order_of_replays(const std::vector<RunRecord>& records);

std::string html_report(const ReportInput& input);
// The page that draws other data; what it looks like is decided in web/main.ts.
std::string page_with(const std::string& title, const std::string& data_json);

// Written to a temporary file beside it and renamed: there is never half a report. Throws
// std::runtime_error naming the file.
void write_html_report(const ReportInput& input, const std::filesystem::path& file);

}  // namespace voronaut
