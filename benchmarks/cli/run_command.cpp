#include <chrono>
#include <ctime>
#include <iostream>
#include <stdexcept>

#include <unistd.h>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/isolation/process_pool.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/shipped_files.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/reports/summary/summary_text.h"

namespace voronaut {

namespace {

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

SuiteSource source_of(const RunOptions& options) {
  const std::string file = find_suite(options.suite).string();
  const std::string text = read_text_file(file);
  ConfigNode::parse(text, file);  // says what is wrong with the file itself
  return {file, text, options.data, options.seed, options.repetitions};
}

ExitCode report_run(const RunReport& run, const OutputFolder& folder,
                    const CommandContext& context) {
  folder.write_csv();
  folder.write_report();
  const std::size_t trials = folder.store().size();
  std::size_t failed = 0;
  folder.store().for_each_record(
      [&](const RunRecord& record) { failed += entry_of(record.outcome).cut_off ? 1 : 0; });
  context.out << summary_text(folder.summary()) << folder.note_on_repetitions() << "\n";
  if (run.stored > 0)
    context.out << run.stored << " trials were there, " << run.done << " are new\n";
  if (failed > 0)
    context.out << failed << " of " << trials
                << " trials ended as crash, killed, memory or invalid\n";
  context.out << "report: " << folder.file("report.html").string() << std::endl;
  return failed > 0 ? ExitCode::failure : ExitCode::success;
}

ExitCode fly(const SuiteConfig& suite, const RunOptions& options, OutputFolder& folder,
             const CommandContext& context) {
  const FlyTrial trial = [&context](const TrialSpec& spec, bool keep_trace) {
    return run_trial(spec, context.planners, keep_trace);
  };
  Progress progress(context.err, isatty(STDERR_FILENO) != 0, SuiteTrials(suite).total(),
                    std::chrono::steady_clock::now());
  const std::size_t jobs = options.jobs > 0 ? options.jobs : ProcessPool::default_jobs();
  ShortestReferences references = isolated_references();
  const RunReport run = run_suite(suite, trial, jobs, references, folder.store(), progress);
  if (run.interrupted) {
    context.err << "voronaut: interrupted; the same command goes on from here" << std::endl;
    return ExitCode::failure;
  }
  return report_run(run, folder, context);
}

}  // namespace

ExitCode execute(const RunOptions& options, const CommandContext& context) {
  SuiteSource source = source_of(options);
  SuiteConfig suite = source.read(context.planners);
  SuiteTrials::check_worlds(suite);
  const SuiteConfig whole = suite;
  if (!options.planners.empty()) keep_planners(suite, options.planners);

  const OutputFolder::Place place{options.out.empty()
                                      ? std::filesystem::path("voronaut-results") / suite.name
                                      : std::filesystem::path(options.out),
                                  !options.out.empty()};
  OutputFolder folder = OutputFolder::prepare(place, source, whole, context.err);
  try {
    folder.write_manifest(manifest_json(source, suite, context.command_line, utc_now()));
    return fly(suite, options, folder, context);
  } catch (const std::exception& error) {  // the input was fine: a full disk, no more processes
    context.err << "voronaut: " << error.what() << std::endl;
    return ExitCode::failure;
  }
}

}  // namespace voronaut
