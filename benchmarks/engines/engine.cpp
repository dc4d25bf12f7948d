#include "voronaut/benchmarks/engines/engine.h"

#include <array>
#include <stdexcept>

namespace voronaut {

namespace {

constexpr std::array<Engine, 4> kEngines{{
    {"slurm", slurm_files},
    {"parallel", parallel_files},
    {"snakemake", snakemake_files},
    {"script", script_files},
}};

std::string line_of(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

}  // namespace

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string ShardedRun::shard_line(const std::string& number) const {
  return line_of(shard_command) + " " + number + "/" + std::to_string(shards);
}

std::string ShardedRun::merge_line() const { return line_of(merge_command); }

std::string ShardedRun::shard_result(const std::string& number) const {
  return shell_word((folder / "shards").string()) + "/" + number + "-of-" + std::to_string(shards) +
         "/results.csv";
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  names.reserve(std::size(kEngines));
  for (const Engine& engine : kEngines) names.emplace_back(engine.name);
  return names;
}

const Engine& engine_of(const std::string& name) {
  for (const Engine& engine : kEngines)
    if (engine.name == name) return engine;
  throw std::invalid_argument("--engine: no engine '" + name + "'");
}

std::filesystem::path engine_folder(const std::filesystem::path& run, std::string_view engine) {
  return run / "engines" / engine;
}

}  // namespace voronaut
