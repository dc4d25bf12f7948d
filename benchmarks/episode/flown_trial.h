#pragma once

#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// A trial of a suite of kind `flown`: fly() and what its log says, as a row. Seeds OMPL: in a
// process of its own, as run_trial().
TrialResult run_flown_trial(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_trace);

}  // namespace voronaut
