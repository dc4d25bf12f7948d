#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "voronaut/benchmarks/results/output_folder.h"

// The parts of a run that was spread over shards.
namespace voronaut {

// Where the folders of the shards of a run lie.
std::filesystem::path shards_in(const std::filesystem::path& run);

// The folders with results that a path means: itself and the shards in it, by name. Empty if there
// are none.
std::vector<std::filesystem::path> folders_with_results(const std::filesystem::path& run);

struct MergeOrder {
  std::vector<std::filesystem::path> folders;  // as folders_with_results() reads them
  std::filesystem::path into;                  // its own results, if it has some, stay
  bool mixed_builds = false;                   // rows of several builds may stand in one table
  std::vector<std::string> command_line = {};  // for the manifest
};

// All rows, worlds, traces and kept files of several folders as one. The result does not depend on
// the order of the folders nor on how often it is asked for; its database appears whole or not at
// all, and nothing is written when the folders do not go together: results of another suite, rows
// of another build, rows of one trial that differ. Throws std::invalid_argument, StoreError.
OutputFolder merge_folders(const MergeOrder& order);

}  // namespace voronaut
