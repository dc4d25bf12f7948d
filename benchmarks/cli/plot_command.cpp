#include <algorithm>
#include <ostream>
#include <stdexcept>
#include <tuple>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/environments/config/nearest_name.h"
#include "voronaut/reports/figures/figure_file.h"
#include "voronaut/reports/figures/figure_panels.h"

namespace voronaut {

namespace {

using Names = std::vector<std::string>;

bool among(const Names& chosen, const std::string& name) {
  return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

// A name that no trial has is a mistake, not an empty choice.
template <class Member>
void require_known(const Names& chosen, const std::vector<RunRecord>& records, const char* option,
                   Member member) {
  Names known;
  for (const RunRecord& record : records) known.push_back(member(record));
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  for (const std::string& name : chosen) {
    if (!std::binary_search(known.begin(), known.end(), name))
      throw std::invalid_argument(option + (" " + in_quotes(name)) + ": no trial has it" +
                                  allowed_names(name, known));
  }
}

// What a figure leaves out because no trace of it is kept, said beside it.
void say_what_is_kept(std::ostream& err, std::size_t kept, std::size_t wanted, bool failures_only) {
  if (kept < wanted)
    err << "voronaut: " << kept << " of " << wanted << " flights of this choice are kept"
        << (failures_only ? ", failures only" : "") << " (see 'traces' in the suite)\n";
}

// By scenario, repetition, vehicle and planner; those without a trace are left out.
Names chosen_trials(const PlotOptions& options, const OutputFolder& folder, std::ostream& err) {
  std::vector<RunRecord> records = folder.store().records();
  std::sort(records.begin(), records.end(), [](const RunRecord& a, const RunRecord& b) {
    return std::tie(a.scenario, a.repetition, a.vehicle, a.planner, a.trial_id) <
           std::tie(b.scenario, b.repetition, b.vehicle, b.planner, b.trial_id);
  });
  require_known(options.scenarios, records, "--scenario", [](auto& r) { return r.scenario; });
  require_known(options.vehicles, records, "--vehicle", [](auto& r) { return r.vehicle; });
  require_known(options.planners, records, "--planner", [](auto& r) { return r.planner; });
  const auto sizes = folder.store().trace_sizes();
  Names ids;
  std::size_t all = 0;
  bool failures_only = true;
  for (const RunRecord& record : records) {
    const bool wanted = among(options.scenarios, record.scenario) &&
                        among(options.vehicles, record.vehicle) &&
                        among(options.planners, record.planner) &&
                        (!options.repetition || *options.repetition == record.repetition);
    all += wanted ? 1U : 0U;
    if (!wanted || !sizes.contains(record.trial_id)) continue;
    ids.push_back(record.trial_id);
    failures_only = failures_only && entry_of(record.outcome).failure;
  }
  if (ids.empty())
    throw std::invalid_argument(
        options.folder + ": no trial of this choice has a trace (see 'traces' in the suite)");
  say_what_is_kept(err, ids.size(), all, failures_only);
  return ids;
}

}  // namespace

ExitCode execute(const PlotOptions& options, const CommandContext& context) {
  check_figure_name(options.out);
  const bool chosen = !options.scenarios.empty() || !options.vehicles.empty() ||
                      !options.planners.empty() || options.repetition.has_value();
  if (chosen == !options.trial_ids.empty())
    throw std::invalid_argument(
        "plot: either trial ids, or a choice by --scenario, --vehicle, --planner, --repetition");
  const OutputFolder folder = OutputFolder::open(options.folder);
  Names ids;
  for (const std::string& beginning : options.trial_ids) {
    ids.push_back(folder.complete_id(beginning));
  }
  if (chosen) ids = chosen_trials(options, folder, context.err);
  write_figure(figure_panels(folder.store(), ids), options.out);
  context.out << options.out << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
