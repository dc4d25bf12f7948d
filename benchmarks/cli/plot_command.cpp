#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/reports/figures/svg_figure.h"
#include "voronaut/reports/store/atomic_file.h"

namespace voronaut {

namespace {

TraceWorld world_of(const ResultStore& store, const RunRecord& record) {
  for (TraceWorld& world : store.worlds())
    if (world.world_id == record.world_id) return std::move(world);
  throw std::invalid_argument("trial " + record.trial_id + ": its world is not stored");
}

FigureTrack track_of(const ResultStore& store, const RunRecord& record) {
  auto trace = store.trace(record.trial_id);
  if (!trace)
    throw std::invalid_argument("trial " + record.trial_id +
                                ": no trace is stored (see 'traces' in the suite)");
  return {record.planner, record.outcome, std::move(*trace)};
}

}  // namespace

ExitCode execute(const PlotOptions& options, const CommandContext& context) {
  const OutputFolder folder = OutputFolder::open(options.folder);
  std::vector<FigurePanel> panels;
  for (const std::string& beginning : options.trial_ids) {
    const RunRecord record = folder.store().record(folder.complete_id(beginning)).value();
    FigureTrack track = track_of(folder.store(), record);
    const auto panel = std::find_if(panels.begin(), panels.end(), [&](const FigurePanel& known) {
      return known.world.world_id == record.world_id;
    });
    if (panel != panels.end()) {
      panel->tracks.push_back(std::move(track));
    } else {
      panels.push_back({record.scenario, world_of(folder.store(), record), {std::move(track)}});
    }
  }
  write_file_atomically(options.out, svg_figure(panels));
  context.out << options.out << "\n";
  return ExitCode::success;
}

}  // namespace voronaut
