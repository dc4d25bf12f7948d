#include "voronaut/benchmarks/cli/options.h"

#include <ostream>

#include "voronaut/benchmarks/cli/option_lists.h"
#include "voronaut/benchmarks/results/build_info.h"

namespace voronaut {

const char* const kOptionsFooter =
    "Exit codes: 0 success; 1 ran, but something failed (a trial ended as crash, killed, memory "
    "or\n"
    "invalid, a replay differed, a criterion is broken, a comparison is worse, the run was\n"
    "interrupted); 2 bad input.";

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary) {
  CLI::App* command = app.add_subcommand(name, summary);
  command->footer(kOptionsFooter);
  return command;
}

void add_folder(CLI::App* command, std::string& folder) {
  command->add_option("DIR", folder, "Folder of results")->required();
}

void add_data(CLI::App* command, std::string& data) {
  command->add_option("--data", data, "Folder of foreign data sets (else VORONAUT_DATA)");
}

void add_settings(CLI::App* command, std::vector<std::string>& settings) {
  command
      ->add_option("--set", settings,
                   "path=value instead of what the suite says, as planners.RRTConnect.range=0.5; "
                   "may be given again (docs/sweeps.md)")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_plugins(CLI::App* command, std::vector<std::string>& plugins) {
  command->add_option("--plugin", plugins, "Shared library with planners; may be given again")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

Commands::Commands(CLI::App& app) {
  add_run(app);
  summary_command = add_command(app, "summary", "Print what a run says about its planners");
  add_folder(summary_command, summary.folder);
  summary_command->add_flag("--json", summary.json, "As JSON");
  summary_command->add_flag("--csv", summary.csv, "As CSV, every statistic with its interval")
      ->excludes("--json");
  list_command = add_command(app, "list", "Print what there is");
  list_command->add_option("WHAT", list.what)
      ->required()
      ->check(CLI::IsMember(
          {"planners", "vehicles", "regulators", "scenarios", "suites", "results", "responses"}));
  add_plugins(list_command, list.plugins);
  check_command = add_command(app, "check", "Validate a suite or scenario without running it");
  check_command
      ->add_option("FILE", check.file, "Suite or scenario file, or the name of a suite that ships")
      ->required();
  add_data(check_command, check.data);
  add_settings(check_command, check.set);
  add_plugins(check_command, check.plugins);
  add_replay(app);
  digest_command = add_command(app, "digest", "Print a hash of every deterministic result");
  add_folder(digest_command, digest.folder);
  digest_command->add_flag("--flights", digest.flights,
                           "Of what was flown alone: no ids, names of keys, modes, reasons");
  add_report(app);
  add_compare(app);
  evidence_command =
      add_command(app, "evidence", "Hold the acceptance criteria of suites against results");
  evidence_command->add_option("DIR", evidence.folders, "Folders of results")->required();
  evidence_command->add_option("-o,--output", evidence.out, "Markdown file [standard output]");
  add_plugins(evidence_command, evidence.plugins);
  add_plot(app);
  add_show(app);
  add_export(app);
  add_schema(app);
  add_merge(app);
  add_status(app);
  add_submit(app);
  add_cancel(app);
  add_tune(app);
}

Options Commands::chosen() const {
  const std::pair<const CLI::App*, Options> all[] = {
      {run_command, run},       {summary_command, summary}, {list_command, list},
      {check_command, check},   {replay_command, replay},   {digest_command, digest},
      {report_command, report}, {compare_command, compare}, {evidence_command, evidence},
      {show_command, show},     {export_command, exported}, {schema_command, schema},
      {merge_command, merge},   {status_command, status},   {submit_command, submit},
      {cancel_command, cancel}, {tune_command, tune},
  };
  for (const auto& [command, options] : all)
    if (command->parsed()) return options;
  return plot;
}

ParsedArguments parse_arguments(int argc, const char* const* argv, std::ostream& out,
                                std::ostream& err) {
  CLI::App app("Benchmarks for planners that discover the world while they move", "voronaut");
  app.set_version_flag("--version", version_line(), "Print the version and exit");
  app.footer(kOptionsFooter);
  app.require_subcommand(1);
  const Commands commands(app);
  for (CLI::App* command : app.get_subcommands({}))
    command->set_version_flag("--version", version_line(), "Print the version and exit");
  try {
    app.parse(argc, argv);
    return {commands.chosen(), ExitCode::success};
  } catch (const CLI::Success& success) {  // help or version
    app.exit(success, out, err);
    return {std::nullopt, ExitCode::success};
  } catch (const CLI::ParseError& error) {
    std::string text = error.what();
    for (char& c : text)
      if (c == '\n') c = ' ';
    err << "voronaut: " << text << " (--help shows what is possible)\n";
    return {std::nullopt, ExitCode::bad_input};
  }
}

}  // namespace voronaut
