#pragma once

#include <vector>

#include <sys/types.h>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/isolation/child_side.h"

// The process between a caller and the tasks of a ChildSeries:
//
//     caller -> supervisor -> guard -> child -> whatever the child starts
//
// The guard is the warm parent: it prepares tasks and forks one child after another, each when the
// caller asks for it, and nothing of one is left when the next is started.
//
// The supervisor is the subreaper of all below it, holds the limits and takes everything along when
// it ends: because all is done, because it was asked to (SIGTERM) or because the caller died; a
// child alone when that reaches a limit. The guard is what the child sees as its parent, so that a
// child that kills its parent kills that one; where the system allows a process namespace it is its
// first process, which cannot be killed from inside. Each is the leader of a session of its own, so
// that none can join another's process group.
namespace voronaut {

// What the supervisor tells its caller when nothing is left of a child.
struct Verdict {
  enum class Cause : int {
    ended,        // the child, by itself or by what others sent it
    guard_ended,  // somebody killed the guard
    stopped,      // the supervisor was asked to
    wall_limit,
    memory,
    not_started,  // no process could be made; `error` is errno
  };
  Cause cause = Cause::not_started;
  bool last = true;  // nothing is left below the supervisor, and it ends
  int error = 0;
  int wait_status = 0;  // of the child; 0 where it was never heard of
  double cpu_time_s = 0;
  double memory_max_mb = 0;
};

struct Supervised {
  const std::vector<ChildSeries::Task>& tasks;
  const ProcessLimits& limits;
  const ChildSeries::Setup& setup;
  pid_t caller;
  int caller_fd;    // a socket: a byte starts a child, a Verdict answers
  ChildSide child;  // its `parent` and what it inherits are filled in by the guard
};

// The supervisor's whole life, begun right after the fork.
[[noreturn]] void supervise(Supervised supervised);

}  // namespace voronaut
