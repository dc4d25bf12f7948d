#include "voronaut/benchmarks/cli/tuning_heat.h"

#include <algorithm>
#include <map>
#include <ostream>

#include "voronaut/benchmarks/cli/flying.h"
#include "voronaut/benchmarks/engines/engine.h"
#include "voronaut/benchmarks/results/merge.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

namespace voronaut {

namespace {

std::vector<RunRecord> rows_of_heat(const Heat& heat, const std::string& identity) {
  std::map<std::string, RunRecord> rows;
  for (const auto& folder : folders_with_results(heat.folder)) {
    const OutputFolder part = OutputFolder::open(folder);
    if (part.store().meta("suite_identity") != identity) continue;
    part.store().for_each_record([&](const RunRecord& record) {
      const bool flies = std::find(heat.planners.begin(), heat.planners.end(), record.planner) !=
                         heat.planners.end();
      if (flies && record.repetition < heat.repetitions) rows.emplace(record.trial_id, record);
    });
  }
  std::vector<RunRecord> list;
  for (auto& [id, record] : rows) list.push_back(std::move(record));
  return list;
}

}  // namespace

Flown fly_heat(Heat heat, std::size_t jobs, bool fly, const CommandContext& context) {
  SuiteConfig suite = heat.source.read(context.planners);
  const SuiteConfig whole = suite;
  keep_planners(suite, heat.planners);
  const std::string identity = suite_identity(whole);
  const std::size_t total = SuiteTrials(suite).total();
  Flown flown;
  flown.rows = rows_of_heat(heat, identity);
  flown.missing = total - flown.rows.size();
  if (flown.missing == 0 || !fly) return flown;
  OutputFolder folder =
      OutputFolder::prepare({heat.folder, true, false}, heat.source, whole, context.err);
  Part part;
  part.share.elsewhere = flown_elsewhere(heat.folder, Shard{}, folder);
  folder.write_manifest(manifest_json(heat.source, suite, context.command_line, ""));
  flown.ended = fly_missing(suite, jobs, part, folder, context).ended;
  flown.rows = rows_of_heat(heat, identity);
  flown.missing = 0;
  return flown;
}

void print_next(const Heat& heat, std::size_t missing, const CommandContext& context) {
  std::string labels;
  for (const std::string& planner : heat.planners) labels += (labels.empty() ? "" : ",") + planner;
  context.out << missing
              << " trials are missing; they may be flown in shards by\n  voronaut submit "
              << shell_word(heat.source.file) << " --engine ENGINE --out "
              << shell_word(heat.folder.string()) << " --repetitions " << heat.repetitions
              << " --planners " << shell_word(labels);
  if (!heat.source.seed.empty()) context.out << " --seed " << heat.source.seed;
  for (const std::string& setting : heat.source.set)
    context.out << " --set " << shell_word(setting);
  context.out << "\nand the same command goes on from there\n" << std::flush;
}

}  // namespace voronaut
