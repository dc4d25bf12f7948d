#include "voronaut/benchmarks/engines/engine.h"

// GNU parallel: shards on this machine, or on several with its --sshlogin.
namespace voronaut {

namespace {

std::string parallel_script(const ShardedRun& run) {
  const std::string shard = run.shard_line("{}") + " && test -e " + run.shard_result("{}");
  return "#!/bin/sh\n"
         "# Flies the shards that are not in its log as done, then merges.\n"
         "# More options, such as --sshloginfile: in PARALLEL, or here.\n"
         "set -eu\n"
         "cd \"$(dirname \"$0\")\"\n"
         "# A log of its own for each text of this file: parallel goes by line numbers.\n"
         "log=shards-$(cksum <submit | cut -d' ' -f1).log\n"
         "seq 1 " +
         std::to_string(run.shards) +
         " >numbers\n"
         "parallel --will-cite --jobs -1 --joblog \"$log\" --resume-failed \\\n  " +
         shell_word(shard) +
         " <numbers &\n"
         "pid=$!\n"
         "echo $pid >pid\n"
         "trap 'kill -TERM $pid; kill -TERM $pid' TERM INT\n"
         "code=0\n"
         "wait $pid || code=$?\n"
         "while kill -0 $pid 2>/dev/null; do wait $pid || code=$?; done\n"
         "rm -f pid\n" +
         run.merge_line() + " || code=$?\nexit $code\n";
}

// parallel starts nothing more after the first SIGTERM and ends what it started after the second.
constexpr const char* kParallelCancel =
    "#!/bin/sh\n"
    "# Ends the parallel that was started from here and no other process.\n"
    "set -eu\n"
    "cd \"$(dirname \"$0\")\"\n"
    "[ -s pid ] || { echo 'parallel: nothing is running'; exit 0; }\n"
    "pid=$(cat pid)\n"
    "case $pid in *[!0-9]* | '') exit 0 ;; esac\n"
    "[ \"$(readlink \"/proc/$pid/cwd\")\" = \"$(pwd -P)\" ] || { rm -f pid; exit 0; }\n"
    "kill -TERM \"$pid\"\n"
    "kill -TERM \"$pid\"\n";

}  // namespace

std::vector<EngineFile> parallel_files(const ShardedRun& run) {
  return {{"submit", parallel_script(run)}, {"cancel", kParallelCancel}};
}

}  // namespace voronaut
