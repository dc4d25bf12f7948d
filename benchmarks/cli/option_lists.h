#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "voronaut/benchmarks/cli/options.h"

// The commands as the parser of the command line knows them.
namespace voronaut {

// What the help of the program and of each command ends with.
extern const char* const kOptionsFooter;

// A value that is one of these names.
CLI::Validator one_of(const std::vector<std::string>& names);
// An option of several values as one word, a,b,...; may be given again. It takes no other word, so
// that none that is meant for something else is lost in it.
CLI::Option* add_list(CLI::App* command, const std::string& name, std::vector<std::string>& values,
                      const std::string& description);

// With the examples of command_examples() in its help.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary);
void add_folder(CLI::App* command, std::string& folder);
void add_data(CLI::App* command, std::string& data);
void add_settings(CLI::App* command, std::vector<std::string>& settings);
void add_plugins(CLI::App* command, std::vector<std::string>& plugins);

// What completes the commands of `app` in a shell (completion.h).
std::string completion_of(const CLI::App& app, const std::string& shell);

// Reads into `options` what belongs to each command; the command that was given says which holds.
struct Commands {
  explicit Commands(CLI::App& app);

  void add_init(CLI::App& app);
  void add_list_command(CLI::App& app);
  void add_check(CLI::App& app);
  void add_summary(CLI::App& app);
  void add_digest(CLI::App& app);
  void add_evidence(CLI::App& app);
  void add_completion(CLI::App& app);
  void add_run(CLI::App& app);
  void add_merge(CLI::App& app);
  void add_status(CLI::App& app);
  void add_submit(CLI::App& app);
  void add_cancel(CLI::App& app);
  void add_tune(CLI::App& app);
  void add_replay(CLI::App& app);
  void add_report(CLI::App& app);
  void add_compare(CLI::App& app);
  void add_plot(CLI::App& app);
  void add_show(CLI::App& app);
  void add_export(CLI::App& app);
  void add_schema(CLI::App& app);

  Options chosen() const;  // of the command that was given

  InitOptions init;
  CompletionOptions completion;
  RunOptions run;
  SummaryOptions summary;
  ListOptions list;
  CheckOptions check;
  ReplayOptions replay;
  DigestOptions digest;
  ReportOptions report;
  CompareOptions compare;
  EvidenceOptions evidence;
  PlotOptions plot;
  ShowOptions show;
  ExportOptions exported;
  SchemaOptions schema;
  MergeOptions merge;
  StatusOptions status;
  SubmitOptions submit;
  CancelOptions cancel;
  TuneOptions tune;

  CLI::App* init_command = nullptr;
  CLI::App* completion_command = nullptr;
  CLI::App* run_command = nullptr;
  CLI::App* summary_command = nullptr;
  CLI::App* list_command = nullptr;
  CLI::App* check_command = nullptr;
  CLI::App* replay_command = nullptr;
  CLI::App* digest_command = nullptr;
  CLI::App* report_command = nullptr;
  CLI::App* compare_command = nullptr;
  CLI::App* evidence_command = nullptr;
  CLI::App* plot_command = nullptr;
  CLI::App* show_command = nullptr;
  CLI::App* export_command = nullptr;
  CLI::App* schema_command = nullptr;
  CLI::App* merge_command = nullptr;
  CLI::App* status_command = nullptr;
  CLI::App* submit_command = nullptr;
  CLI::App* cancel_command = nullptr;
  CLI::App* tune_command = nullptr;
};

}  // namespace voronaut
