#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>
#include <vector>

// What the command line says, as plain values.
namespace voronaut {

// A suite, and what is changed about it.
struct SuiteChoice {
  std::string suite;  // a path, or the name of a suite that ships
  std::vector<std::string> planners;
  std::string seed;  // empty: the suite's
  std::string repetitions;
  std::string data;
  std::vector<std::string> set;      // "path=value" each
  std::vector<std::string> plugins;  // shared libraries with planners
};

struct RunOptions : SuiteChoice {
  std::string out;       // empty: voronaut-results/<suite>
  std::size_t jobs = 0;  // 0: all cores but one
  std::string shard;     // "2/8"; empty: the whole suite
  bool dry_run = false;
};

struct MergeOptions {
  std::vector<std::string> folders;  // of results, or of runs in shards
  std::string out;
  bool mixed_builds = false;
};

struct StatusOptions : SuiteChoice {  // no suite: the one that the folder keeps
  std::string folder;
};

struct SubmitOptions : SuiteChoice {
  std::string engine;
  std::string out;         // empty: voronaut-results/<suite>
  std::size_t shards = 0;  // 0: by the number of trials
  std::size_t jobs = 1;    // in a shard
  bool dry_run = false;
};

struct TuneOptions : SuiteChoice {  // all planners of the suite but one stay on the ground
  std::string planner;
  std::vector<std::string> over;  // "key=LOW:HIGH" or "key=LOW:HIGH:log"
  std::vector<std::string> objectives{"success", "path_ratio"};
  std::size_t candidates = 16;
  std::string out;  // empty: voronaut-results/<suite>-tune
  std::size_t jobs = 0;
  bool dry_run = false;
};

struct CancelOptions {
  std::string folder;
};

struct SummaryOptions {
  std::string folder;
  bool json = false;
  bool csv = false;
};

struct InitOptions {
  std::string folder;
};

struct CompletionOptions {
  std::string shell;  // bash, zsh, fish
};

struct ListOptions {
  std::string what;
  std::string name;  // one of them, whose parameters are asked for; empty: all
  std::vector<std::string> plugins;
};

struct CheckOptions {
  std::string file;
  std::string data;
  std::vector<std::string> set;  // of a suite
  std::vector<std::string> plugins;
};

struct ReplayOptions {
  std::string folder;
  std::string trial_id;  // or the beginning of one
  std::vector<std::string> plugins;
};

struct DigestOptions {
  std::string folder;
  bool flights = false;
};

struct ReportOptions {
  std::string folder;     // or a file: what voronaut-micro printed as JSON
  std::string data;       // recorded lidar for it
  std::string out;        // empty: report.html in the folder; md and csv: the terminal
  std::string compare;    // another folder of results; empty: none
  std::string published;  // a file of what others published; empty: none
  std::string format = "html";
};

struct CompareOptions {
  std::vector<std::string> folders;     // before, now; with planners one
  std::vector<std::string> planners;    // two labels, before and now, within one folder
  std::string published;                // a file of what others published; empty: none
  std::vector<std::string> statistics;  // empty: all that are not measured times
  std::vector<std::string> across;      // keys of the suite that are meant to differ
  double tolerance = 0.02;              // points of a share, relative of the rest
  std::string format = "text";
  std::vector<std::string> plugins;
};

struct EvidenceOptions {
  std::vector<std::string> folders;
  std::string out;  // a Markdown file; empty: standard output
  std::vector<std::string> plugins;
};

struct PlotOptions {
  std::string folder;
  std::vector<std::string> trial_ids;  // or their beginnings; else the choice below
  std::vector<std::string> scenarios;  // empty: all
  std::vector<std::string> vehicles;   // the same
  std::vector<std::string> planners;   // the same, by label
  std::optional<std::int64_t> repetition;
  std::string out;  // .svg or .png
};

struct ShowOptions {
  std::string file;    // a scenario or a foreign world
  std::string format;  // of a foreign world; empty: as the file looks
  std::string out;     // .svg or .png
  std::uint64_t seed = 1;
  std::string data;
};

struct ExportOptions {
  std::string folder;
  std::string format;  // ompl-log, plannerarena, csv, mcap
  std::string out;     // empty: export.<ending> in the folder
};

struct SchemaOptions {
  std::string of = "suite";     // or scenario: of which files
  std::string format = "json";  // or md: all keys of both
  std::vector<std::string> plugins;
};

using Options =
    std::variant<RunOptions, SummaryOptions, ListOptions, CheckOptions, ReplayOptions,
                 DigestOptions, ReportOptions, CompareOptions, EvidenceOptions, PlotOptions,
                 ShowOptions, ExportOptions, SchemaOptions, MergeOptions, StatusOptions,
                 SubmitOptions, CancelOptions, TuneOptions, InitOptions, CompletionOptions>;

// 0: done. 1: ran, but something failed. 2: bad input.
enum class ExitCode { success = 0, failure = 1, bad_input = 2 };

struct ParsedArguments {
  std::optional<Options> options;  // empty: help, version or an error was printed
  ExitCode exit_code = ExitCode::success;
};

ParsedArguments parse_arguments(int argc, const char* const* argv, std::ostream& out,
                                std::ostream& err);

}  // namespace voronaut
