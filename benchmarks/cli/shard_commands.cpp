#include <map>
#include <ostream>
#include <stdexcept>
#include <unordered_map>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/isolated_world.h"
#include "voronaut/benchmarks/suite/suite_trials.h"
#include "voronaut/reports/summary/text_table.h"

// A run that was spread over shards: made one again, and looked at.
namespace voronaut {

ExitCode execute(const MergeOptions& options, const CommandContext& context) {
  const MergeOrder order{{options.folders.begin(), options.folders.end()},
                         options.out,
                         options.mixed_builds,
                         context.command_line};
  const OutputFolder merged = merge_folders(order);
  context.out << merged.store().trial_ids().size() << " trials in " << options.out << "\n"
              << merged.note_on_builds();
  return ExitCode::success;
}

namespace {

struct Count {
  std::size_t done = 0;
  std::size_t missing = 0;
  std::size_t failed = 0;
};

using FailedById = std::unordered_map<std::string, bool>;

// All rows of a run, wherever they lie.
FailedById rows_of(const std::vector<std::filesystem::path>& folders, const std::string& identity) {
  FailedById failed;
  for (const auto& folder : folders) {
    const OutputFolder part = OutputFolder::open(folder);
    if (part.store().meta("suite_identity") != identity)
      throw std::invalid_argument(folder.string() +
                                  ": holds results of another version of this "
                                  "suite");
    for (const RunRecord& record : part.store().records())
      failed[record.trial_id] = entry_of(record.outcome).cut_off;
  }
  return failed;
}

std::map<std::string, Count> count_by_planner(const SuiteConfig& suite, const FailedById& failed) {
  std::map<std::string, Count> counts;
  SuiteTrials trials(suite, rehearse_in_child());
  while (const auto planned = trials.next()) {
    Count& count = counts[planned->spec.planner.label];
    const auto row = failed.find(planned->spec.trial_id);
    if (row == failed.end()) {
      ++count.missing;
    } else {
      ++(row->second ? count.failed : count.done);
    }
  }
  return counts;
}

std::vector<std::string> row_of(const std::string& name, const Count& count) {
  return {name, std::to_string(count.done), std::to_string(count.missing),
          std::to_string(count.failed)};
}

SuiteSource source_of_status(const StatusOptions& options,
                             const std::vector<std::filesystem::path>& folders) {
  if (!options.suite.empty()) return source_of(options);
  if (folders.empty())
    throw std::invalid_argument(options.folder +
                                ": no results here (no results.db, no shards); SUITE says what is "
                                "missing of which suite");
  SuiteSource source = OutputFolder::open(folders.front()).source();
  if (!options.seed.empty()) source.seed = options.seed;
  if (!options.repetitions.empty()) source.repetitions = options.repetitions;
  source.set.insert(source.set.end(), options.set.begin(), options.set.end());
  return source;
}

}  // namespace

ExitCode execute(const StatusOptions& options, const CommandContext& context) {
  const auto folders = folders_with_results(options.folder);
  SuiteConfig suite = source_of_status(options, folders).read(context.planners);
  const FailedById rows = rows_of(folders, suite_identity(suite));
  if (!options.planners.empty()) keep_planners(suite, options.planners);
  const auto counts = count_by_planner(suite, rows);

  TextTable table{{{"planner", TextTable::Align::left}, {"done"}, {"missing"}, {"failed"}}, {}};
  Count all;
  for (const PlannerSpec& planner : suite.planners) {
    const Count& count = counts.at(planner.label);
    table.rows.push_back(row_of(printable(planner.label), count));
    all.done += count.done;
    all.missing += count.missing;
    all.failed += count.failed;
  }
  table.rows.push_back(row_of("all", all));
  context.out << table.aligned();
  return all.missing > 0 ? ExitCode::failure : ExitCode::success;
}

}  // namespace voronaut
