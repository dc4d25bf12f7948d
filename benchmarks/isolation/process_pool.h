#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <vector>

#include "voronaut/benchmarks/isolation/child_process.h"
#include "voronaut/benchmarks/isolation/stop_signals.h"

namespace voronaut {

// Runs jobs in child processes, several at once. Stop signals end it in order: nothing more is
// started and what is in flight is dropped.
class ProcessPool {
 public:
  struct Job {
    ChildSeries::Work work;                        // in the child
    std::function<void()> prepare;                 // in the parent of the child; may be empty
    std::function<void()> starts;                  // in the caller, before the child; may be empty
    std::function<void(const ChildReport&)> done;  // in the caller, as soon as it has ended
  };

  enum class End {
    all_done,
    interrupted,  // SIGINT: somebody at a terminal
    stopped,      // SIGTERM, SIGUSR1: an engine that wants the machine back
  };

  // jobs >= 1 children at once. `tick` is called between events, at least every 0.2 s.
  ProcessPool(StopSignals& stop, std::size_t jobs, const ProcessLimits& limits,
              ChildSeries::Setup setup, std::function<void()> tick);
  ~ProcessPool();

  // Asks `next` for jobs whenever a place is free, until it has none; those that come together are
  // done one after another by one series of children. Exceptions of `next`, `starts` and `done`
  // pass through; children in flight are killed then.
  End run(const std::function<std::vector<Job>()>& next);

  // As many as a machine bears without disturbing its clocks: all cores but one, at least one.
  static std::size_t default_jobs();

 private:
  class Lane;
  void fill_lanes(const std::function<std::vector<Job>()>& next);
  void wait_for_events();
  void attend();
  std::vector<Job> next_jobs(const std::function<std::vector<Job>()>& next);

  StopSignals& stop_;
  std::size_t jobs_;
  ProcessLimits limits_;
  ChildSeries::Setup setup_;
  std::function<void()> tick_;
  std::list<Lane> lanes_;
  std::vector<Job> left_over_;  // of a series that could not go on
  bool more_ = true;
};

}  // namespace voronaut
