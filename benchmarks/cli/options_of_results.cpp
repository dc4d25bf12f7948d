#include <cstdint>
#include <limits>

#include "voronaut/benchmarks/cli/completion.h"
#include "voronaut/benchmarks/cli/option_lists.h"
#include "voronaut/environments/formats/foreign_formats.h"

// Commands that look at results, and at what there is.
namespace voronaut {

void Commands::add_summary(CLI::App& app) {
  summary_command = add_command(app, "summary", "Print what a run says about its planners");
  add_folder(summary_command, summary.folder);
  summary_command->add_flag("--json", summary.json, "As JSON");
  summary_command->add_flag("--csv", summary.csv, "As CSV, every statistic with its interval")
      ->excludes("--json");
}

void Commands::add_list_command(CLI::App& app) {
  list_command = add_command(app, "list", "Print what there is, or what one of it may be told");
  list_command->add_option("WHAT", list.what, "What there is of these")
      ->required()
      ->check(one_of({"planners", "vehicles", "regulators", "generators", "scenarios", "datasets",
                      "formats", "suites", "results", "responses"}));
  list_command->add_option("NAME", list.name,
                           "A planner, vehicle, regulator or generator: print its parameters");
  add_plugins(list_command, list.plugins);
}

void Commands::add_check(CLI::App& app) {
  check_command = add_command(app, "check", "Validate a suite or scenario without running it");
  check_command
      ->add_option("FILE", check.file,
                   "Suite or scenario file, or the name of what `list` has of them")
      ->required();
  add_data(check_command, check.data);
  add_settings(check_command, check.set);
  add_plugins(check_command, check.plugins);
}

void Commands::add_digest(CLI::App& app) {
  digest_command = add_command(app, "digest", "Print a hash of every deterministic result");
  add_folder(digest_command, digest.folder);
  digest_command->add_flag("--flights", digest.flights,
                           "Of what was flown alone: no ids, names of keys, modes, reasons");
}

void Commands::add_evidence(CLI::App& app) {
  evidence_command =
      add_command(app, "evidence", "Hold the acceptance criteria of suites against results");
  evidence_command->add_option("DIR", evidence.folders, "Folders of results")->required();
  evidence_command->add_option("-o,--output", evidence.out, "Markdown file [standard output]");
  add_plugins(evidence_command, evidence.plugins);
}

void Commands::add_completion(CLI::App& app) {
  completion_command =
      add_command(app, "completion", "Print what completes these commands in a shell");
  completion_command->add_option("SHELL", completion.shell)
      ->required()
      ->check(one_of(completed_shells()));
}

void Commands::add_replay(CLI::App& app) {
  replay_command =
      add_command(app, "replay", "Fly a stored trial again: is the result the same, bit for bit?");
  add_folder(replay_command, replay.folder);
  replay_command->add_option("TRIAL_ID", replay.trial_id, "Or the beginning of it")->required();
  add_plugins(replay_command, replay.plugins);
}

void Commands::add_report(CLI::App& app) {
  report_command = add_command(app, "report", "Write what a run says about its planners");
  report_command
      ->add_option("DIR", report.folder,
                   "Folder of results (micro.json of voronaut-micro in it becomes a page), or "
                   "such a file alone")
      ->required();
  add_data(report_command, report.data);
  report_command->add_option("-o,--output", report.out,
                             "File [html: report.html in DIR; else the terminal]");
  report_command->add_option("--compare", report.compare, "Another folder of results, before DIR");
  report_command->add_option("--published", report.published,
                             "CSV of what others published of BARN's courses (docs/barn.md)");
  report_command->add_option("--format", report.format, "html, md or csv [html]")
      ->check(one_of({"html", "md", "csv"}));
}

void Commands::add_compare(CLI::App& app) {
  compare_command =
      add_command(app, "compare",
                  "Say what changed between two runs or planners; exit code 1 if for the worse");
  compare_command->add_option("DIR", compare.folders, "Folders of results: before, now")
      ->required()
      ->expected(1, 2);
  add_list(compare_command, "--planners", compare.planners,
           "Two planners of one folder, by label: X,Y");
  compare_command->add_option("--published", compare.published,
                              "CSV of what others published of BARN's courses (docs/barn.md)");
  add_list(compare_command, "--statistics", compare.statistics,
           "Only these, a,b,... [all but measured times]");
  compare_command
      ->add_option("--across", compare.across,
                   "Key of the suites that is meant to differ; may be given again")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  compare_command
      ->add_option("--tolerance", compare.tolerance,
                   "Worse by less passes: points of a share, relative of the rest [0.02]")
      ->check(CLI::Range(0.0, 1.0));
  compare_command->add_option("--format", compare.format, "text, md or json [text]")
      ->check(one_of({"text", "md", "json"}));
  add_plugins(compare_command, compare.plugins);
}

void Commands::add_plot(CLI::App& app) {
  plot_command = add_command(app, "plot", "Draw trials as a figure, one panel per world");
  add_folder(plot_command, plot.folder);
  plot_command->add_option("TRIAL_ID", plot.trial_ids, "Or their beginnings");
  add_list(plot_command, "--scenario", plot.scenarios, "Instead of ids: only these, a,b,...");
  add_list(plot_command, "--vehicle", plot.vehicles, "Instead of ids: only these");
  add_list(plot_command, "--planner", plot.planners, "Instead of ids: only these, by label");
  plot_command->add_option("--repetition", plot.repetition, "Instead of ids: this one, from 0");
  plot_command->add_option("-o,--output", plot.out, "File.svg or file.png")->required();
}

void Commands::add_show(CLI::App& app) {
  show_command = add_command(app, "show", "Draw a scenario or a foreign world as a figure");
  show_command
      ->add_option("FILE", show.file,
                   "Scenario file, a file of docs/formats.md, or the name of what `list` has")
      ->required();
  show_command->add_option("-o,--output", show.out, "File.svg, file.png or file.wkt")->required();
  show_command->add_option("--format", show.format, "Of a foreign world [as the file looks]")
      ->check(one_of(foreign_format_names()));
  show_command->add_option("--seed", show.seed, "Of a random world")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  add_data(show_command, show.data);
}

void Commands::add_export(CLI::App& app) {
  export_command = add_command(app, "export", "Write results in a format of other tools");
  add_folder(export_command, exported.folder);
  export_command->add_option("--format", exported.format)
      ->required()
      ->check(one_of({"ompl-log", "plannerarena", "csv", "mcap"}));
  export_command->add_option("-o,--output", exported.out, "File [export.* in DIR]");
}

void Commands::add_schema(CLI::App& app) {
  schema_command = add_command(app, "schema", "Print what suite and scenario files may say");
  schema_command->add_option("OF", schema.of, "suite or scenario [suite]")
      ->check(one_of({"suite", "scenario"}));
  schema_command->add_option("--format", schema.format, "json (JSON Schema) or md [json]")
      ->check(one_of({"json", "md"}));
  add_plugins(schema_command, schema.plugins);
}

}  // namespace voronaut
