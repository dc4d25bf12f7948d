#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "voronaut/benchmarks/cli/commands.h"
#include "voronaut/reports/run_record.h"

// What a tuning flies, and what is there of it.
namespace voronaut {

// A part of the trials: some candidates, so often.
struct Heat {
  std::filesystem::path folder;
  SuiteSource source;
  std::vector<std::string> planners;
  int repetitions = 1;
};

struct Flown {
  std::vector<RunRecord> rows;
  std::size_t missing = 0;
  std::optional<ExitCode> ended;  // early
};

// Flies what is missing of a heat, or only says how much that is. Rows count wherever they lie in
// the folder, so shards that an engine has flown do.
Flown fly_heat(Heat heat, std::size_t jobs, bool fly, const CommandContext& context);

// How what is missing may be flown by an engine.
void print_next(const Heat& heat, std::size_t missing, const CommandContext& context);

}  // namespace voronaut
