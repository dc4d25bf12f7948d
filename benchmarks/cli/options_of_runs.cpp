#include <cstdint>
#include <limits>

#include "voronaut/benchmarks/cli/option_lists.h"
#include "voronaut/benchmarks/engines/engine.h"
#include "voronaut/benchmarks/suite/shard.h"

// Commands that fly a suite, or look after a run of one.
namespace voronaut {

namespace {

// Which suite, and what is changed about it. Returns the option of its name.
CLI::Option* add_suite_alone(CLI::App* command, SuiteChoice& choice,
                             const std::string& otherwise = {}) {
  CLI::Option* suite = command->add_option(
      "SUITE", choice.suite,
      "Suite file, or the name of one that ships" + (otherwise.empty() ? "" : " " + otherwise));
  command->add_option("--seed", choice.seed, "Instead of the suite's")
      ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  command->add_option("--repetitions", choice.repetitions, "Instead of the suite's")
      ->check(CLI::Range(1, 1'000'000));
  add_settings(command, choice.set);
  add_data(command, choice.data);
  add_plugins(command, choice.plugins);
  return suite;
}

// The same with a choice of its planners.
CLI::Option* add_suite(CLI::App* command, SuiteChoice& choice, const std::string& otherwise = {}) {
  add_list(command, "--planners", choice.planners, "Only these, by label: a,b,...");
  return add_suite_alone(command, choice, otherwise);
}

}  // namespace

void Commands::add_init(CLI::App& app) {
  init_command = add_command(app, "init", "Begin: write a suite, a scenario and a world to change");
  init_command->add_option("DIR", init.folder, "A new folder, or an empty one")->required();
}

void Commands::add_run(CLI::App& app) {
  run_command = add_command(app, "run", "Fly a suite; complete what is missing of it");
  add_suite(run_command, run)->required();
  run_command->add_option("--out", run.out, "Folder of results [voronaut-results/<suite>]");
  run_command->add_option("--jobs", run.jobs, "Trials at once [all cores but one]")
      ->check(CLI::Range(1, 1024));
  run_command->add_option("--shard", run.shard, "One of n parts of it: i/n, from 1/n to n/n");
  run_command->add_flag("--dry-run", run.dry_run,
                        "Say what would be flown and how long it may take; write nothing");
}

void Commands::add_merge(CLI::App& app) {
  merge_command = add_command(app, "merge", "Make one folder of the shards of a run");
  merge_command->add_option("DIR", merge.folders, "Folders of results, or of runs in shards")
      ->required();
  merge_command->add_option("-o,--output", merge.out, "Folder; may be one of them")->required();
  merge_command->add_flag("--mixed-builds", merge.mixed_builds,
                          "Take rows of several builds; the report says so");
}

void Commands::add_status(CLI::App& app) {
  status_command = add_command(app, "status", "Print what of a suite is done, missing and failed");
  status_command->add_option("DIR", status.folder, "Folder of results, or of a run in shards")
      ->required();
  add_suite(status_command, status, "[the one that DIR keeps]");
}

void Commands::add_submit(CLI::App& app) {
  submit_command = add_command(app, "submit", "Fly a suite in shards on an engine");
  add_suite(submit_command, submit)->required();
  submit_command->add_option("--engine", submit.engine, "What starts the shards")
      ->required()
      ->check(one_of(engine_names()));
  submit_command->add_option("--out", submit.out, "Folder of results [voronaut-results/<suite>]");
  submit_command->add_option("--shards", submit.shards, "How many [by the number of trials]")
      ->check(CLI::Range(std::size_t{1}, Shard::kCountMax));
  submit_command->add_option("--jobs", submit.jobs, "Trials at once in a shard [1]")
      ->check(CLI::Range(1, 1024));
  submit_command->add_flag("--dry-run", submit.dry_run, "Write the files, submit nothing");
}

void Commands::add_cancel(CLI::App& app) {
  cancel_command = add_command(app, "cancel", "End what was submitted for a folder of results");
  add_folder(cancel_command, cancel.folder);
}

void Commands::add_tune(CLI::App& app) {
  tune_command =
      add_command(app, "tune", "Find better parameters of a planner on the worlds of a suite");
  add_suite_alone(tune_command, tune)->required();
  tune_command->add_option("--planner", tune.planner, "Which one, by label")->required();
  add_list(tune_command, "--over", tune.over,
           "Its keys and their bounds: range=0.1:5:log,goal_bias=0:0.5; log: equal ratios")
      ->required();
  add_list(tune_command, "--for", tune.objectives,
           "What counts, equally: success, statistics or columns [success,path_ratio]");
  tune_command->add_option("--candidates", tune.candidates, "How many begin, it as it is too [16]")
      ->check(CLI::Range(2, 1024));
  tune_command->add_option("--out", tune.out, "Folder [voronaut-results/<suite>-tune]");
  tune_command->add_option("--jobs", tune.jobs, "Trials at once [all cores but one]")
      ->check(CLI::Range(1, 1024));
  tune_command->add_flag("--dry-run", tune.dry_run,
                         "Fly nothing; say how what comes next may be flown in shards");
}

}  // namespace voronaut
