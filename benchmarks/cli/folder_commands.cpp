#include <ostream>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/runner/run_trial.h"
#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/reports/summary/summary_text.h"

namespace voronaut {

ExitCode execute(const SummaryOptions& options, const CommandContext& context) {
  const OutputFolder folder = OutputFolder::open(options.folder);
  const Summary summary = folder.summary();
  const auto axes = axis_columns(folder.store().meta("sweep").value_or(""));
  context.out << (options.json  ? summary_json(summary, axes) + "\n"
                  : options.csv ? summary_csv(summary, axes)
                                : summary_text(summary) + folder.note_on_repetitions() +
                                      folder.note_on_builds());
  return ExitCode::success;
}

ExitCode execute(const DigestOptions& options, const CommandContext& context) {
  const OutputFolder folder = OutputFolder::open(options.folder);
  const ResultStore& store = folder.store();
  context.out << (options.flights ? flights_digest(store) : digest(store)) << "\n";
  return ExitCode::success;
}

namespace {

TrialSpec find_trial(const SuiteConfig& suite, const std::string& id) {
  SuiteTrials trials(suite, rehearse_in_child());
  while (auto planned = trials.next()) {
    if (planned->spec.trial_id != id) continue;
    if (!planned->refusal.empty())
      throw std::invalid_argument("trial " + id + ": " + planned->refusal);
    return std::move(planned->spec);
  }
  throw std::invalid_argument("trial " + id +
                              ": the suite does not make it any more; its scenario files, its data "
                              "or the program have changed");
}

}  // namespace

ExitCode execute(const ReplayOptions& options, const CommandContext& context) {
  const OutputFolder folder = OutputFolder::open(options.folder);
  const std::string id = folder.complete_id(options.trial_id);
  const RunRecord stored = folder.store().record(id).value();
  const SuiteConfig suite = folder.source().read(context.planners);
  TrialSpec spec = find_trial(suite, id);
  isolated_references().add_to(spec);
  const RunRecord flown =
      run_alone(spec, suite.limits, [&](const TrialSpec& trial, bool keep_trace) {
        return run_trial(trial, context.planners, keep_trace);
      });
  if (const std::string difference = difference_text(stored, flown); !difference.empty()) {
    context.out << "trial " << id << " differs: " << difference << "\n";
    return ExitCode::failure;
  }
  context.out << "trial " << id << " is the same, bit for bit (" << to_string(flown.outcome)
              << ")\n";
  return ExitCode::success;
}

}  // namespace voronaut
