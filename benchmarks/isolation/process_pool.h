#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "voronaut/benchmarks/isolation/child_process.h"

namespace voronaut {

// Runs jobs in child processes, several at once. SIGINT, SIGTERM and SIGUSR1 stop it in order:
// nothing more is started and what is in flight is dropped.
class ProcessPool {
 public:
  struct Job {
    ChildProcess::Work work;                       // in the child
    std::function<void(const ChildReport&)> done;  // in the parent, as soon as the child has ended
  };

  enum class End {
    all_done,
    interrupted,  // SIGINT: somebody at a terminal
    stopped,      // SIGTERM, SIGUSR1: an engine that wants the machine back
  };

  // jobs >= 1 children at once. `tick` is called between events, at least every 0.2 s.
  ProcessPool(std::size_t jobs, const ProcessLimits& limits, ChildProcess::Setup setup,
              std::function<void()> tick);

  // Asks `next` for a job whenever a place is free, until it has none. Exceptions of `next` and
  // `done` pass through; children in flight are killed then.
  End run(const std::function<std::optional<Job>()>& next);

  // As many as a machine bears without disturbing its clocks: all cores but one, at least one.
  static std::size_t default_jobs();

 private:
  std::size_t jobs_;
  ProcessLimits limits_;
  ChildProcess::Setup setup_;
  std::function<void()> tick_;
};

}  // namespace voronaut
