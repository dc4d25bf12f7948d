#include "voronaut/benchmarks/engines/engine.h"

// Slurm: an array with a task for each shard, and a job that merges after it, whatever became of
// it.
namespace voronaut {

namespace {

// SIGUSR1 comes a minute before the time limit, SIGTERM when a task is preempted, requeued or
// cancelled: `exec` makes the run the process that gets them, and it ends in order.
std::string array_script(const ShardedRun& run) {
  return "#!/bin/sh\n"
         "#SBATCH --job-name=voronaut-" +
         run.suite + "\n#SBATCH --array=1-" + std::to_string(run.shards) +
         "\n#SBATCH --cpus-per-task=" + std::to_string(run.jobs) +
         "\n#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --signal=B:USR1@60\n"
         "#SBATCH --output=shard-%a.log\n"
         "exec " +
         run.shard_line("\"$SLURM_ARRAY_TASK_ID\"") + "\n";
}

std::string merge_script(const ShardedRun& run) {
  return "#!/bin/sh\n"
         "#SBATCH --job-name=voronaut-" +
         run.suite +
         "-merge\n#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --output=merge.log\n"
         "exec " +
         run.merge_line() + "\n";
}

// Slurm takes indices below MaxArraySize.
std::string submit_script(const ShardedRun& run) {
  return "#!/bin/sh\n"
         "# Submits all shards, and merges after them. Those that are complete end at once.\n"
         "# Account, partition, time: SBATCH_ACCOUNT, SBATCH_PARTITION, SBATCH_TIMELIMIT.\n"
         "set -eu\n"
         "cd \"$(dirname \"$0\")\"\n"
         "most=$(scontrol show config | awk '$1 == \"MaxArraySize\" { print $3 - 1 }')\n"
         "if [ " +
         std::to_string(run.shards) +
         " -gt \"$most\" ]; then\n"
         "  echo \"" +
         std::to_string(run.shards) +
         " shards, and this Slurm takes $most (MaxArraySize)\" >&2\n"
         "  exit 2\n"
         "fi\n"
         "shards=$(sbatch --parsable shards.sbatch | cut -d';' -f1)\n"
         "echo \"$shards\" >>jobs\n"
         "merge=$(sbatch --parsable --dependency=\"afterany:$shards\" merge.sbatch | cut -d';' "
         "-f1)\n"
         "echo \"$merge\" >>jobs\n"
         "echo \"Slurm: shards are job $shards, merging is job $merge\"\n";
}

constexpr const char* kSlurmCancel =
    "#!/bin/sh\n"
    "# Ends the jobs that were submitted from here and no others.\n"
    "set -eu\n"
    "cd \"$(dirname \"$0\")\"\n"
    "[ -s jobs ] || { echo 'Slurm: nothing was submitted'; exit 0; }\n"
    "while read -r job; do\n"
    "  case $job in *[!0-9]* | '') continue ;; esac\n"
    "  scancel --quiet \"$job\" || true  # it has ended\n"
    "done <jobs\n"
    "rm -f jobs\n";

}  // namespace

std::vector<EngineFile> slurm_files(const ShardedRun& run) {
  return {{"shards.sbatch", array_script(run)},
          {"merge.sbatch", merge_script(run)},
          {"submit", submit_script(run)},
          {"cancel", kSlurmCancel}};
}

}  // namespace voronaut
