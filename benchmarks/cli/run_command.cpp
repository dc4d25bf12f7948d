#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>
#include <optional>
#include <set>
#include <stdexcept>

#include <unistd.h>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/cli/dry_run.h"
#include "voronaut/benchmarks/cli/flying.h"
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

// Says what became of the acceptance criteria; false if one is broken.
bool criteria_hold(const SuiteConfig& suite, const OutputFolder& folder, std::ostream& out) {
  if (suite.acceptance.empty()) return true;
  std::vector<std::string> flying;
  for (const PlannerSpec& planner : suite.planners) flying.push_back(planner.label);
  const Finding all = examine_all(suite.acceptance, flying, folder.store().records());
  out << "acceptance:\n" << all.text;
  return all.holds;
}

ExitCode report_run(const RunReport& run, const SuiteConfig& suite, const OutputFolder& folder,
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
  const bool accepted = criteria_hold(suite, folder, context.out);
  context.out << "report: " << folder.file("report.html").string() << std::endl;
  return failed > 0 || !accepted ? ExitCode::failure : ExitCode::success;
}

// Its rows are the business of whoever merges them; that it is complete is said by its results.csv.
ExitCode report_shard(const Shard& shard, const OutputFolder& folder,
                      const CommandContext& context) {
  folder.write_csv();
  context.out << "shard " << shard.text() << " is complete" << std::endl;
  return ExitCode::success;
}

}  // namespace

SuiteSource source_of(const SuiteChoice& choice) {
  const std::string file = find_suite(choice.suite).string();
  const std::string text = read_text_file(file);
  ConfigNode::parse(text, file);  // says what is wrong with the file itself
  return {file, text, choice.data, choice.seed, choice.repetitions, {}, choice.set};
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
  if (options.dry_run) {
    print_dry_run({source, suite, whole, run, part.share.shard, options.jobs}, context);
    return ExitCode::success;
  }
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
    const FlownPart flown = fly_missing(suite, options.jobs, part, folder, context);
    if (flown.ended) return *flown.ended;
    return part.shard ? report_shard(*part.shard, folder, context)
                      : report_run(flown.run, suite, folder, context);
  } catch (const std::exception& error) {  // the input was fine: a full disk, no more processes
    context.err << "voronaut: " << error.what() << std::endl;
    return ExitCode::failure;
  }
}

}  // namespace voronaut
