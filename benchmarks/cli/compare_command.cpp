#include <algorithm>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/digest.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/results/published_file.h"
#include "voronaut/benchmarks/results/suite_differences.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/reports/summary/comparison_text.h"

namespace voronaut {

namespace {

// What the command compares unless it is told: all that does not hang on the machine.
bool by_default(const Statistic& statistic) {
  const RecordColumn* column = column_of(statistic);
  return column == nullptr || column->kind != ColumnKind::measured;
}

std::vector<const Statistic*> statistics_of(const CompareOptions& options) {
  std::vector<const Statistic*> chosen;
  std::vector<std::string> names;
  for (const Statistic& one : statistics()) {
    names.emplace_back(one.name);
    if (options.statistics.empty() && by_default(one)) chosen.push_back(&one);
  }
  for (const std::string& name : options.statistics) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw std::invalid_argument("--statistics: no statistic " + in_quotes(name) +
                                  allowed_names(name, names));
    chosen.push_back(&statistic(name));
  }
  return chosen;
}

ComparisonConfig config_of(const CompareOptions& options) {
  ComparisonConfig config;
  config.statistics = statistics_of(options);
  config.tolerance = options.tolerance;
  config.same_flight = same_flight;
  return config;
}

RunComparison compare_folders(const CompareOptions& options, const CommandContext& context) {
  const OutputFolder before = OutputFolder::open(options.folders[0]);
  const OutputFolder now = OutputFolder::open(options.folders[1]);
  const std::vector<std::string> differing = suite_differences(
      before.source().read(context.planners), now.source().read(context.planners), options.across);
  if (!differing.empty())
    throw std::invalid_argument(
        options.folders[1] + ": not to be compared with " + options.folders[0] + ": " +
        differing.front() +
        (differing.size() > 1 ? " and " + std::to_string(differing.size() - 1) + " more" : "") +
        " (what is meant to differ: --across KEY)");
  return now.compare_with(before, config_of(options));
}

// The trials of one planner, by a name that both sides of the comparison share. At the end
// std::invalid_argument if there was none.
NextRecord trials_of(const std::string& planner, const std::string& name,
                     const ResultStore& store) {
  return [next = store.records_in(kPairingOrder), planner, name, any = false,
          known = std::set<std::string>()]() mutable -> std::optional<RunRecord> {
    while (auto record = next()) {
      known.insert(record->planner);
      if (record->planner != planner) continue;
      any = true;
      record->planner = name;
      return record;
    }
    if (!any)
      throw std::invalid_argument("--planners: no trial of " + in_quotes(planner) +
                                  allowed_names(planner, {known.begin(), known.end()}));
    return std::nullopt;
  };
}

RunComparison compare_planners(const CompareOptions& options) {
  const OutputFolder folder = OutputFolder::open(options.folders[0]);
  const std::string& before = options.planners[0];
  const std::string& now = options.planners[1];
  RunComparison comparison =
      compare_runs(trials_of(now, now, folder.store()), trials_of(before, now, folder.store()),
                   config_of(options));
  comparison.title = before;
  return comparison;
}

std::string text_of(const RunComparison& comparison, const std::string& format) {
  if (format == "json") return comparison_json(comparison) + "\n";
  return format == "md" ? comparison_markdown(comparison) : comparison_text(comparison);
}

// Courses of BARN beside what others published of them.
ExitCode compare_published(const CompareOptions& options, const CommandContext& context) {
  if (options.folders.size() != 1 || !options.planners.empty())
    throw std::invalid_argument("compare: --published goes with one folder");
  const BarnComparison comparison =
      beside_published_file(OutputFolder::open(options.folders[0]), options.published);
  if (options.format == "json")
    context.out << barn_json(comparison) << "\n";
  else
    context.out << (options.format == "md" ? barn_markdown(comparison) : barn_text(comparison));
  return ExitCode::success;
}

}  // namespace

ExitCode execute(const CompareOptions& options, const CommandContext& context) {
  if (!options.published.empty()) return compare_published(options, context);
  const bool within = options.planners.size() == 2;
  if (options.folders.size() != (within ? 1U : 2U))
    throw std::invalid_argument("compare: expected two folders, or one with --planners X,Y");
  const RunComparison comparison =
      within ? compare_planners(options) : compare_folders(options, context);
  if (comparison.pairs == 0)
    throw std::invalid_argument("compare: no trial has a partner, nothing to compare");
  const bool identical =
      comparison.changed == 0 && comparison.only_here == 0 && comparison.only_there == 0;
  if (identical && options.format != "json") {
    context.out << "identical: all " << comparison.pairs << " trials flew alike\n";
    return ExitCode::success;
  }
  context.out << text_of(comparison, options.format);
  return comparison.changed > 0 && comparison.worse() ? ExitCode::failure : ExitCode::success;
}

}  // namespace voronaut
