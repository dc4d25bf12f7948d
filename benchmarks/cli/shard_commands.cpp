#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

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
  context.out << merged.store().size() << " trials in " << options.out << "\n"
              << merged.note_on_builds();
  return ExitCode::success;
}

namespace {

struct Count {
  std::size_t done = 0;
  std::size_t missing = 0;
  std::size_t failed = 0;
};

// Whether each stored trial was cut off, by the first half of its id, which is 128 bits.
class StoredTrials {
 public:
  void add(const std::string& id, bool failed) { trials_.emplace_back(half_of(id), failed); }
  // Of a trial that several folders hold the last one counts.
  void sort() {
    std::stable_sort(trials_.begin(), trials_.end(),
                     [](const Trial& a, const Trial& b) { return a.first < b.first; });
  }
  std::optional<bool> failed(const std::string& id) const {
    const auto after =
        std::upper_bound(trials_.begin(), trials_.end(), half_of(id),
                         [](const Half& half, const Trial& trial) { return half < trial.first; });
    if (after == trials_.begin() || std::prev(after)->first != half_of(id)) return std::nullopt;
    return std::prev(after)->second;
  }

 private:
  using Half = std::array<char, 32>;
  using Trial = std::pair<Half, bool>;
  static Half half_of(const std::string& id) {
    Half half{};
    std::copy_n(id.begin(), std::min(id.size(), half.size()), half.begin());
    return half;
  }
  std::deque<Trial> trials_;
};

// All rows of a run, wherever they lie.
StoredTrials rows_of(const std::vector<std::filesystem::path>& folders,
                     const std::string& identity) {
  StoredTrials rows;
  for (const auto& folder : folders) {
    const OutputFolder part = OutputFolder::open(folder);
    if (part.store().meta("suite_identity") != identity)
      throw std::invalid_argument(folder.string() +
                                  ": holds results of another version of this "
                                  "suite");
    part.store().for_each_record(
        [&](const RunRecord& record) {
          rows.add(record.trial_id, entry_of(record.outcome).cut_off);
        },
        "rowid");
  }
  rows.sort();
  return rows;
}

std::map<std::string, Count> count_by_planner(const SuiteConfig& suite, const StoredTrials& rows) {
  std::map<std::string, Count> counts;
  SuiteTrials trials(suite, rehearse_in_child());
  while (const auto planned = trials.next()) {
    Count& count = counts[planned->spec.planner.label];
    const std::optional<bool> failed = rows.failed(planned->spec.trial_id);
    ++(!failed ? count.missing : *failed ? count.failed : count.done);
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
  const StoredTrials rows = rows_of(folders, suite_identity(suite));
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
