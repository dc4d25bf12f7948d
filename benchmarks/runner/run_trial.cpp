#include "voronaut/benchmarks/runner/run_trial.h"

#include <ompl/util/Console.h>

#include "voronaut/benchmarks/episode/flown_trial.h"
#include "voronaut/benchmarks/static_planning/static_trial.h"

namespace voronaut {

TrialResult run_trial(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_trace) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  return spec.kind == TrialKind::static_planning ? run_static_trial(spec, planners, keep_trace)
                                                 : run_flown_trial(spec, planners, keep_trace);
}

}  // namespace voronaut
