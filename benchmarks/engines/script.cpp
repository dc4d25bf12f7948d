#include "voronaut/benchmarks/engines/engine.h"

// For whatever starts commands: the shards, one a line, in any order, and what comes after them.
namespace voronaut {

std::vector<EngineFile> script_files(const ShardedRun& run) {
  std::string shards;
  for (std::size_t i = 1; i <= run.shards; ++i) shards += run.shard_line(std::to_string(i)) + "\n";
  return {{"shards.txt", shards}, {"merge.txt", run.merge_line() + "\n"}};
}

}  // namespace voronaut
