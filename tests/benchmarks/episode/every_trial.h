#pragma once

#include <vector>

#include "voronaut/benchmarks/suite/shortest_references.h"
#include "voronaut/benchmarks/suite/suite_trials.h"

namespace voronaut {

// The trials of a suite with their references, ready to be flown.
inline std::vector<TrialSpec> every_trial(const SuiteConfig& suite) {
  std::vector<TrialSpec> specs;
  SuiteTrials trials(suite);
  ShortestReferences references = ShortestReferences::exact();
  while (auto trial = trials.next()) {
    references.add_to(trial->spec);
    specs.push_back(trial->spec);
  }
  return specs;
}

}  // namespace voronaut
