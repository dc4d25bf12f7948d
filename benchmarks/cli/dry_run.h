#pragma once

#include <filesystem>
#include <string>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/benchmarks/suite/shard.h"

namespace voronaut {

// A run that is not made.
struct DryRun {
  const SuiteSource& source;
  const SuiteConfig& suite;  // with the planners that are asked for
  const SuiteConfig& whole;
  std::filesystem::path folder;
  Shard shard;
  std::size_t jobs = 0;  // 0: all cores but one
};

// Prints how many trials a run would fly of each planner, the files that it read, and how long it
// may take: by what trials of this suite cost that its folder holds; of a planner without any, by
// a few that are flown for it in some seconds and forgotten. Shortest paths and worlds, made once
// for many trials, are not in it. Writes nothing.
void print_dry_run(const DryRun& run, const CommandContext& context);

// "suite 'smoke', 2 scenarios x 1 vehicles x 3 planners x 2 repetitions = 12 trials", and a line
// for each axis that it sweeps over.
std::string size_text(const SuiteConfig& suite);

}  // namespace voronaut
