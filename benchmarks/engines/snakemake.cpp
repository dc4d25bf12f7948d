#include "voronaut/benchmarks/engines/engine.h"

// Snakemake: a rule for the shards, one that merges.
namespace voronaut {

namespace {

// As Python reads it. Braces are doubled, for Snakemake formats the text.
std::string python_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
    if (c == '{' || c == '}') quoted += c;
  }
  return quoted + "\"";
}

// Where `{number}` stands for the number of a shard.
std::string with_number(std::string text, const std::string& field) {
  const std::string stand_in = "@number@";
  for (std::size_t at = text.find(stand_in); at != std::string::npos; at = text.find(stand_in))
    text.replace(at, stand_in.size(), field);
  return text;
}

std::string snakefile(const ShardedRun& run) {
  const std::string shard = (run.folder / "shards" / "@number@-of-").string() +
                            std::to_string(run.shards) + "/results.csv";
  const std::string result = with_number(python_text(shard), "{number}");
  const std::string merged = python_text((run.folder / "results.csv").string());
  return "# A shard is complete when its results.csv is there.\n"
         "rule merge:\n    input: expand(" +
         result + ", number=range(1, " + std::to_string(run.shards + 1) +
         "))\n    output: " + merged + "\n    shell: " + python_text(run.merge_line()) +
         "\n\nrule shard:\n    output: " + result + "\n    threads: " + std::to_string(run.jobs) +
         "\n    shell: " +
         with_number(python_text(run.shard_line("@number@")), "{wildcards.number}") + "\n";
}

constexpr const char* kSnakemakeSubmit =
    "#!/bin/sh\n"
    "# Flies the shards that are not complete, then merges. No lock of Snakemake's: each shard "
    "has\n"
    "# its own. On a cluster: the options --cluster or --profile of snakemake, here.\n"
    "set -eu\n"
    "cd \"$(dirname \"$0\")\"\n"
    "setsid snakemake --snakefile Snakefile --cores all --keep-going --nolock \\\n"
    "  --rerun-incomplete &\n"
    "pid=$!\n"
    "echo $pid >pid\n"
    "trap 'kill -s TERM -- -$pid' TERM INT\n"
    "code=0\n"
    "wait $pid || code=$?\n"
    "while kill -0 $pid 2>/dev/null; do wait $pid || code=$?; done\n"
    "rm -f pid\n"
    "exit $code\n";

constexpr const char* kSnakemakeCancel =
    "#!/bin/sh\n"
    "# Ends the Snakemake that was started from here with its shards, and no other process.\n"
    "set -eu\n"
    "cd \"$(dirname \"$0\")\"\n"
    "[ -s pid ] || { echo 'Snakemake: nothing is running'; exit 0; }\n"
    "pid=$(cat pid)\n"
    "case $pid in *[!0-9]* | '') exit 0 ;; esac\n"
    "[ \"$(readlink \"/proc/$pid/cwd\")\" = \"$(pwd -P)\" ] || { rm -f pid; exit 0; }\n"
    "kill -s TERM -- \"-$pid\"\n";

}  // namespace

std::vector<EngineFile> snakemake_files(const ShardedRun& run) {
  return {
      {"Snakefile", snakefile(run)}, {"submit", kSnakemakeSubmit}, {"cancel", kSnakemakeCancel}};
}

}  // namespace voronaut
