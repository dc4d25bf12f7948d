#pragma once

#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// Flies one trial, or solves it if its kind is `static`, in this process: seeds OMPL, so it must be
// the first to use a random number in its process (fork before). Never throws for what a planner
// does within its contract; exceptions of a planner or std::bad_alloc pass through, the caller
// makes rows of them.
TrialResult run_trial(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_trace);

}  // namespace voronaut
