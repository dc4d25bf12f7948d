#pragma once

#include <vector>

#include <sys/types.h>

// Everything that descends from a process, as /proc shows it: who is there, what it holds in
// memory, and its end. None of it needs a privilege.
namespace voronaut {

// Children, their children and so on, parents first.
std::vector<pid_t> descendants_of(pid_t root);

// Memory of a trial, counted while it runs.
class TreeMemory {
 public:
  // `bystander` is a process that was forked together with the trial's and touches nothing: what it
  // shares with the trial is not the trial's.
  explicit TreeMemory(pid_t bystander);

  // Memory of the processes in `pids` without what came with the fork, plus shared pages and memory
  // files (memfd, /dev/shm) that they have open, each once. An upper bound as long as that is below
  // `limit_mb`, which costs a few reads for each process; the kernel's own division of shared pages
  // above, which costs a walk over its page tables. Shared mappings and open memory files are
  // counted by the larger of the two sums, so half of what is both may be missed, never more.
  double in_use_mb(const std::vector<pid_t>& pids, double limit_mb) const;

 private:
  pid_t bystander_;
  double resident_at_fork_mb_;
};

// Sends SIGKILL to all descendants of `root` but `spared` (0: nobody), each held by a descriptor
// while it is made sure that the number is still that of a descendant.
void kill_descendants(pid_t root, pid_t spared);

}  // namespace voronaut
