#pragma once

#include "voronaut/benchmarks/isolation/supervisor.h"

// The warm parent of a ChildSeries (supervisor.h).
namespace voronaut {

// What the guard tells the supervisor of a child when nothing is left of it.
struct ChildEnd {
  int error = 0;        // of fork
  bool spoilt = false;  // it left something that only the end of the guard takes away
  int wait_status = 0;
  double cpu_time_s = 0;
  double memory_max_mb = 0;  // beyond what it inherited
};

struct Guarded {
  Supervised& supervised;
  int supervisor_fd;    // a socket: a byte starts a child, a ChildEnd answers
  bool own_namespaces;  // it is the first process of a process namespace and has an IPC namespace
};

// The guard's whole life, begun right after the fork. Runs no work: prepares tasks, forks children,
// takes their leavings away.
[[noreturn]] void guard(const Guarded& guarded);

}  // namespace voronaut
