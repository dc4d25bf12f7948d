#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// What starts the shards of a run, on one machine or many. None of them is ours: an engine here is
// the text of a few files, readable, and one that submits them again however often.
namespace voronaut {

// What an engine is to start: `shards` commands in any order, then one.
struct ShardedRun {
  std::string suite;             // its name
  std::filesystem::path folder;  // of the run, absolute
  std::size_t shards = 1;
  std::size_t jobs = 1;                    // that a shard keeps busy
  std::vector<std::string> shard_command;  // but for the last word, i/n
  std::vector<std::string> merge_command;

  // The command of a shard for a shell; `number` is put where its number stands, unquoted.
  std::string shard_line(const std::string& number) const;
  std::string merge_line() const;
  // What is there once a shard is complete, for a shell.
  std::string shard_result(const std::string& number) const;
};

struct EngineFile {
  std::string name;
  std::string text;
};

struct Engine {
  std::string_view name;
  // Without names of their own, in a folder of theirs: "submit" and "cancel" are shell scripts
  // that are run there; an engine that has none of the first leaves the submitting to the user.
  std::vector<EngineFile> (*files)(const ShardedRun& run);
};

// One line of a table for each.
std::vector<EngineFile> slurm_files(const ShardedRun& run);
std::vector<EngineFile> parallel_files(const ShardedRun& run);
std::vector<EngineFile> snakemake_files(const ShardedRun& run);
std::vector<EngineFile> script_files(const ShardedRun& run);

std::vector<std::string> engine_names();
const Engine& engine_of(const std::string& name);  // one of the names

// Where the files of an engine stand.
std::filesystem::path engine_folder(const std::filesystem::path& run, std::string_view engine);

// A word as a POSIX shell reads it back.
std::string shell_word(const std::string& word);

}  // namespace voronaut
