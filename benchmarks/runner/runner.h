#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>

#include "voronaut/benchmarks/runner/progress.h"
#include "voronaut/benchmarks/suite/shard.h"
#include "voronaut/benchmarks/suite/shortest_references.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/reports/store/store.h"

namespace voronaut {

// Flies one trial; called in a process of its own. run_trial() with a catalogue bound to it.
using FlyTrial = std::function<TrialResult(const TrialSpec& spec, bool keep_trace)>;

struct RunReport {
  std::size_t stored = 0;    // were there before
  std::size_t done = 0;      // are there now because of this run
  bool interrupted = false;  // by SIGINT
  bool stopped = false;      // asked to end early, by SIGTERM or SIGUSR1
};

// What of a suite a run is to fly.
struct RunShare {
  Shard shard = {};
  std::set<std::string> elsewhere = {};  // trials whose rows other stores hold
};

// Runs what the store lacks of a suite, `jobs` trials at once, each in its own process under the
// suite's limits, with the folder of the store read-only to it where the system allows that. Every
// trial becomes a row as soon as it has ended, whatever became of it or, before it began, of its
// world and its references; what somebody killed is flown once more at the end. SIGINT,
// SIGTERM and SIGUSR1 end the run early and drop what is in flight; a run that was ended in any way
// is completed by the next. One runner works on a store at a time.
RunReport run_suite(const SuiteConfig& suite, const FlyTrial& fly, std::size_t jobs,
                    ShortestReferences& references, ResultStore& store, Progress& progress,
                    const RunShare& share = {});

// The same for one trial, apart from any store. What the planner prints stays visible.
RunRecord run_alone(const TrialSpec& spec, const TrialLimits& limits, const FlyTrial& fly);

// The row of a trial that did not come back by itself.
RunRecord record_of_failure(const TrialSpec& spec, Outcome outcome, const std::string& reason);

}  // namespace voronaut
