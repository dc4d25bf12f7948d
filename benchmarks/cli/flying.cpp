#include "voronaut/benchmarks/cli/flying.h"

#include <chrono>
#include <csignal>
#include <ostream>

#include <unistd.h>

#include "voronaut/benchmarks/isolation/process_pool.h"
#include "voronaut/benchmarks/results/build_info.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/suite/shared_references.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

namespace voronaut {

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

void hold_stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGUSR1);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
}

FlownPart fly_missing(const SuiteConfig& suite, std::size_t jobs, const Part& part,
                      OutputFolder& folder, const CommandContext& context) {
  const FlyTrial trial = [&context](const TrialSpec& spec, bool keep_trace) {
    return run_trial(spec, context.planners, keep_trace);
  };
  Progress progress(context.err, isatty(STDERR_FILENO) != 0,
                    SuiteTrials(suite).total() / part.share.shard.count,
                    std::chrono::steady_clock::now());
  SharedReferences shared(folder.path(), "references-" + program_id().substr(0, 12) + ".txt");
  ShortestReferences references = part.shard
                                      ? ShortestReferences(shared.sharing(isolated_length()),
                                                           shared.sharing(isolated_difficulty()))
                                      : isolated_references();
  const RunReport run = run_suite(suite, trial, jobs > 0 ? jobs : ProcessPool::default_jobs(),
                                  references, folder.store(), progress, part.share);
  if (run.stopped) {
    context.err << "voronaut: asked to stop; the same command goes on from here" << std::endl;
    return {run, ExitCode::success};
  }
  if (run.interrupted) {
    context.err << "voronaut: interrupted; the same command goes on from here" << std::endl;
    return {run, ExitCode::failure};
  }
  return {run, std::nullopt};
}

}  // namespace voronaut
