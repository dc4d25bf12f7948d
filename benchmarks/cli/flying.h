#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/benchmarks/runner/runner.h"

// How commands fly suites.
namespace voronaut {

// What of its suite a folder is to hold.
struct Part {
  std::optional<Shard> shard;  // else all of it
  RunShare share;
};

// Trials of a shard whose rows other folders of its run hold, as they do when the number of shards
// has changed. Those of another suite or build do not count.
std::set<std::string> flown_elsewhere(const std::filesystem::path& run, const Shard& shard,
                                      const OutputFolder& own);

// An engine that asks this to stop while it prepares is heard as soon as it would fly; when all is
// flown, it ends anyhow. For the rest of the process.
void hold_stop_signals();

struct FlownPart {
  RunReport run;
  std::optional<ExitCode> ended;  // before all was flown
};

// Flies what the folder lacks, `jobs` trials at once (0: all cores but one). If it is ended early
// it says so on `context.err`.
FlownPart fly_missing(const SuiteConfig& suite, std::size_t jobs, const Part& part,
                      OutputFolder& folder, const CommandContext& context);

}  // namespace voronaut
