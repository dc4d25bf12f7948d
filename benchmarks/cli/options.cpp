#include "voronaut/benchmarks/cli/options.h"

#include <ostream>

#include <CLI/CLI.hpp>

#include "voronaut/benchmarks/engines/engine.h"
#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/benchmarks/suite/shard.h"
#include "voronaut/environments/formats/foreign_formats.h"

namespace voronaut {

namespace {

constexpr const char* kFooter =
    "Exit codes: 0 success; 1 ran, but something failed (a trial ended as crash, killed, memory "
    "or\n"
    "invalid, a replay differed, a criterion is broken, a comparison is worse, the run was\n"
    "interrupted); 2 bad input.";

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& summary) {
  CLI::App* command = app.add_subcommand(name, summary);
  command->footer(kFooter);
  return command;
}

void add_folder(CLI::App* command, std::string& folder) {
  command->add_option("DIR", folder, "Folder of results")->required();
}

void add_data(CLI::App* command, std::string& data) {
  command->add_option("--data", data, "Folder of foreign data sets (else VORONAUT_DATA)");
}

void add_plugins(CLI::App* command, std::vector<std::string>& plugins) {
  command->add_option("--plugin", plugins, "Shared library with planners; may be given again")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

// Which suite, and what is changed about it. Returns the option of its name.
CLI::Option* add_suite(CLI::App* command, SuiteChoice& choice, const std::string& otherwise = {}) {
  CLI::Option* suite = command->add_option(
      "SUITE", choice.suite,
      "Suite file, or the name of one that ships" + (otherwise.empty() ? "" : " " + otherwise));
  command->add_option("--planners", choice.planners, "Only these, by label: a,b,...")
      ->delimiter(',');
  command->add_option("--seed", choice.seed, "Instead of the suite's")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  command->add_option("--repetitions", choice.repetitions, "Instead of the suite's")
      ->check(CLI::Range(1, 1'000'000));
  add_data(command, choice.data);
  add_plugins(command, choice.plugins);
  return suite;
}

// Reads into `options` what belongs to each command; the command that was given says which holds.
struct Commands {
  explicit Commands(CLI::App& app) {
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
            {"planners", "vehicles", "regulators", "scenarios", "suites", "results"}));
    add_plugins(list_command, list.plugins);
    check_command = add_command(app, "check", "Validate a suite or scenario without running it");
    check_command
        ->add_option("FILE", check.file,
                     "Suite or scenario file, or the name of a suite that ships")
        ->required();
    add_data(check_command, check.data);
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
  }

  void add_run(CLI::App& app) {
    run_command = add_command(app, "run", "Fly a suite; complete what is missing of it");
    add_suite(run_command, run)->required();
    run_command->add_option("--out", run.out, "Folder of results [voronaut-results/<suite>]");
    run_command->add_option("--jobs", run.jobs, "Trials at once [all cores but one]")
        ->check(CLI::Range(1, 1024));
    run_command->add_option("--shard", run.shard, "One of n parts of it: i/n, from 1/n to n/n");
  }

  void add_merge(CLI::App& app) {
    merge_command = add_command(app, "merge", "Make one folder of the shards of a run");
    merge_command->add_option("DIR", merge.folders, "Folders of results, or of runs in shards")
        ->required();
    merge_command->add_option("-o,--output", merge.out, "Folder; may be one of them")->required();
    merge_command->add_flag("--mixed-builds", merge.mixed_builds,
                            "Take rows of several builds; the report says so");
  }

  void add_status(CLI::App& app) {
    status_command =
        add_command(app, "status", "Print what of a suite is done, missing and failed");
    status_command->add_option("DIR", status.folder, "Folder of results, or of a run in shards")
        ->required();
    add_suite(status_command, status, "[the one that DIR keeps]");
  }

  void add_submit(CLI::App& app) {
    submit_command = add_command(app, "submit", "Fly a suite in shards on an engine");
    add_suite(submit_command, submit)->required();
    submit_command->add_option("--engine", submit.engine, "What starts the shards")
        ->required()
        ->check(CLI::IsMember(engine_names()));
    submit_command->add_option("--out", submit.out, "Folder of results [voronaut-results/<suite>]");
    submit_command->add_option("--shards", submit.shards, "How many [by the number of trials]")
        ->check(CLI::Range(std::size_t{1}, Shard::kCountMax));
    submit_command->add_option("--jobs", submit.jobs, "Trials at once in a shard [1]")
        ->check(CLI::Range(1, 1024));
    submit_command->add_flag("--dry-run", submit.dry_run, "Write the files, submit nothing");
  }

  void add_cancel(CLI::App& app) {
    cancel_command = add_command(app, "cancel", "End what was submitted for a folder of results");
    add_folder(cancel_command, cancel.folder);
  }

  void add_replay(CLI::App& app) {
    replay_command = add_command(app, "replay",
                                 "Fly a stored trial again: is the result the same, bit for bit?");
    add_folder(replay_command, replay.folder);
    replay_command->add_option("TRIAL_ID", replay.trial_id, "Or the beginning of it")->required();
    add_plugins(replay_command, replay.plugins);
  }

  void add_report(CLI::App& app) {
    report_command = add_command(app, "report", "Write what a run says about its planners");
    report_command
        ->add_option("DIR", report.folder,
                     "Folder of results (micro.json of voronaut-micro in it becomes a page), or "
                     "such a file alone")
        ->required();
    add_data(report_command, report.data);
    report_command->add_option("-o,--output", report.out,
                               "File [html: report.html in DIR; else the terminal]");
    report_command->add_option("--compare", report.compare,
                               "Another folder of results, before DIR");
    report_command->add_option("--format", report.format, "html, md or csv [html]")
        ->check(CLI::IsMember({"html", "md", "csv"}));
  }

  void add_compare(CLI::App& app) {
    compare_command =
        add_command(app, "compare",
                    "Say what changed between two runs or planners; exit code 1 if for the worse");
    compare_command->add_option("DIR", compare.folders, "Folders of results: before, now")
        ->required()
        ->expected(1, 2);
    compare_command
        ->add_option("--planners", compare.planners, "Two planners of one folder, by label: X Y")
        ->expected(2);
    compare_command->add_option("--published", compare.published,
                                "CSV of what others published of BARN's courses (docs/barn.md)");
    compare_command
        ->add_option("--statistics", compare.statistics,
                     "Only these, a,b,... [all but measured times]")
        ->delimiter(',');
    compare_command
        ->add_option("--across", compare.across,
                     "Key of the suites that is meant to differ; may be given again")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    compare_command
        ->add_option("--tolerance", compare.tolerance,
                     "Worse by less passes: points of a share, relative of the rest [0.02]")
        ->check(CLI::Range(0.0, 1.0));
    compare_command->add_option("--format", compare.format, "text, md or json [text]")
        ->check(CLI::IsMember({"text", "md", "json"}));
    add_plugins(compare_command, compare.plugins);
  }

  void add_plot(CLI::App& app) {
    plot_command = add_command(app, "plot", "Draw trials as a figure, one panel per world");
    add_folder(plot_command, plot.folder);
    plot_command->add_option("TRIAL_ID", plot.trial_ids, "Or their beginnings");
    plot_command->add_option("--scenario", plot.scenarios, "Instead of ids: only these, a,b,...")
        ->delimiter(',');
    plot_command->add_option("--vehicle", plot.vehicles, "Instead of ids: only these")
        ->delimiter(',');
    plot_command->add_option("--planner", plot.planners, "Instead of ids: only these, by label")
        ->delimiter(',');
    plot_command->add_option("--repetition", plot.repetition, "Instead of ids: this one, from 0");
    plot_command->add_option("-o,--output", plot.out, "File.svg or file.png")->required();
  }

  void add_show(CLI::App& app) {
    show_command = add_command(app, "show", "Draw a scenario or a foreign world as a figure");
    show_command->add_option("FILE", show.file, "Scenario file, or a file of docs/formats.md")
        ->required();
    show_command->add_option("-o,--output", show.out, "File.svg, file.png or file.wkt")->required();
    show_command->add_option("--format", show.format, "Of a foreign world [as the file looks]")
        ->check(CLI::IsMember(foreign_format_names()));
    show_command->add_option("--seed", show.seed, "Of a random world")
        ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
    add_data(show_command, show.data);
  }

  void add_export(CLI::App& app) {
    export_command = add_command(app, "export", "Write results in a format of other tools");
    add_folder(export_command, exported.folder);
    export_command->add_option("--format", exported.format)
        ->required()
        ->check(CLI::IsMember({"ompl-log", "plannerarena", "csv", "mcap"}));
    export_command->add_option("-o,--output", exported.out, "File [export.* in DIR]");
  }

  void add_schema(CLI::App& app) {
    schema_command = add_command(app, "schema", "Print what suite and scenario files may say");
    schema_command->add_option("OF", schema.of, "suite or scenario [suite]")
        ->check(CLI::IsMember({"suite", "scenario"}));
    schema_command->add_option("--format", schema.format, "json (JSON Schema) or md [json]")
        ->check(CLI::IsMember({"json", "md"}));
    add_plugins(schema_command, schema.plugins);
  }

  Options chosen() const {
    const std::pair<const CLI::App*, Options> all[] = {
        {run_command, run},       {summary_command, summary}, {list_command, list},
        {check_command, check},   {replay_command, replay},   {digest_command, digest},
        {report_command, report}, {compare_command, compare}, {evidence_command, evidence},
        {show_command, show},     {export_command, exported}, {schema_command, schema},
        {merge_command, merge},   {status_command, status},   {submit_command, submit},
        {cancel_command, cancel},
    };
    for (const auto& [command, options] : all)
      if (command->parsed()) return options;
    return plot;
  }

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
};

}  // namespace

ParsedArguments parse_arguments(int argc, const char* const* argv, std::ostream& out,
                                std::ostream& err) {
  CLI::App app("Benchmarks for planners that discover the world while they move", "voronaut");
  app.set_version_flag("--version", version_line(), "Print the version and exit");
  app.footer(kFooter);
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
