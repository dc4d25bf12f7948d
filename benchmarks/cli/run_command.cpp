#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>

#include <unistd.h>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/isolation/process_pool.h"
#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/shared_references.h"
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

ExitCode report_run(const RunReport& run, const OutputFolder& folder,
                    const CommandContext& context) {
  folder.write_csv();
  folder.write_report();
  const std::size_t trials = folder.store().size();
  std::size_t failed = 0;
  folder.store().for_each_record(
      [&](const RunRecord& record) { failed += entry_of(record.outcome).cut_off ? 1 : 0; });
  context.out << summary_text(folder.summary()) << folder.note_on_repetitions()
              << folder.note_on_builds() << "\n";
  if (run.stored > 0)
    context.out << run.stored << " trials were there, " << run.done << " are new\n";
  if (failed > 0)
    context.out << failed << " of " << trials
                << " trials ended as crash, killed, memory or invalid\n";
  context.out << "report: " << folder.file("report.html").string() << std::endl;
  return failed > 0 ? ExitCode::failure : ExitCode::success;
}

// Trials of a shard whose rows other folders of its run hold, as they do when the number of shards
// has changed. Those of another suite or build do not count.
std::set<std::string> flown_elsewhere(const std::filesystem::path& run, const Shard& shard,
                                      const OutputFolder& own) {
  std::set<std::string> ids;
  const std::string same_count = "-of-" + std::to_string(shard.count);
  for (const auto& folder : folders_with_results(run)) {
    if (folder != run && folder.filename().string().ends_with(same_count)) continue;
    const OutputFolder other = OutputFolder::open(folder);
    if (other.store().meta("suite_identity") != own.store().meta("suite_identity") ||
        other.builds() != own.builds())
      continue;
    for (std::string& id : other.store().trial_ids())
      if (shard.holds(id)) ids.insert(std::move(id));
  }
  return ids;
}

// Its rows are the business of whoever merges them; that it is complete is said by its results.csv.
ExitCode report_shard(const Shard& shard, const OutputFolder& folder,
                      const CommandContext& context) {
  folder.write_csv();
  context.out << "shard " << shard.text() << " is complete" << std::endl;
  return ExitCode::success;
}

// An engine that asks this to stop while it prepares is heard as soon as it would fly; when all is
// flown, it ends anyhow. For the rest of the process.
void hold_stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGUSR1);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
}

// What of its suite a folder is to hold.
struct Part {
  std::optional<Shard> shard;  // else all of it
  RunShare share;
};

ExitCode fly(const SuiteConfig& suite, const RunOptions& options, const Part& part,
             OutputFolder& folder, const CommandContext& context) {
  const FlyTrial trial = [&context](const TrialSpec& spec, bool keep_trace) {
    return run_trial(spec, context.planners, keep_trace);
  };
  Progress progress(context.err, isatty(STDERR_FILENO) != 0,
                    SuiteTrials(suite).total() / part.share.shard.count,
                    std::chrono::steady_clock::now());
  const std::size_t jobs = options.jobs > 0 ? options.jobs : ProcessPool::default_jobs();
  SharedReferences shared(folder.path(), "references-" + program_id().substr(0, 12) + ".txt");
  ShortestReferences references = part.shard
                                      ? ShortestReferences(shared.sharing(isolated_length()),
                                                           shared.sharing(isolated_difficulty()))
                                      : isolated_references();
  const RunReport run =
      run_suite(suite, trial, jobs, references, folder.store(), progress, part.share);
  if (run.stopped) {
    context.err << "voronaut: asked to stop; the same command goes on from here" << std::endl;
    return ExitCode::success;
  }
  if (run.interrupted) {
    context.err << "voronaut: interrupted; the same command goes on from here" << std::endl;
    return ExitCode::failure;
  }
  return part.shard ? report_shard(*part.shard, folder, context) : report_run(run, folder, context);
}

}  // namespace

SuiteSource source_of(const SuiteChoice& choice) {
  const std::string file = find_suite(choice.suite).string();
  const std::string text = read_text_file(file);
  ConfigNode::parse(text, file);  // says what is wrong with the file itself
  return {file, text, choice.data, choice.seed, choice.repetitions};
}

std::filesystem::path run_folder(const std::string& out, const SuiteConfig& suite) {
  return out.empty() ? std::filesystem::path("voronaut-results") / suite.name
                     : std::filesystem::path(out);
}

ExitCode execute(const RunOptions& options, const CommandContext& context) {
  hold_stop_signals();
  SuiteSource source = source_of(options);
  SuiteConfig suite = source.read(context.planners);
  SuiteTrials::check_worlds(suite);
  const SuiteConfig whole = suite;
  if (!options.planners.empty()) keep_planners(suite, options.planners);

  const std::filesystem::path run = run_folder(options.out, suite);
  Part part;
  if (!options.shard.empty()) part.shard = part.share.shard = Shard::parse(options.shard);
  const OutputFolder::Place place{part.shard ? shards_in(run) / part.shard->folder_name() : run,
                                  !options.out.empty(), part.shard.has_value()};
  OutputFolder folder = OutputFolder::prepare(place, source, whole, context.err);
  try {
    if (part.shard) {
      std::filesystem::remove(folder.file("results.csv"));  // of a shard that was complete before
      part.share.elsewhere = flown_elsewhere(run, *part.shard, folder);
    }
    folder.write_manifest(
        manifest_json(source, suite, context.command_line, utc_now(), options.shard));
    return fly(suite, options, part, folder, context);
  } catch (const std::exception& error) {  // the input was fine: a full disk, no more processes
    context.err << "voronaut: " << error.what() << std::endl;
    return ExitCode::failure;
  }
}

}  // namespace voronaut
