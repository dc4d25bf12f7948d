#pragma once

#include <functional>
#include <string>

#include "voronaut/benchmarks/runner/runner.h"
#include "voronaut/benchmarks/suite/suite_config.h"
#include "voronaut/tests/support/temporary_folder.h"

// Suites of a few trials that no planner has to fly: a made-up flight answers for each.
namespace voronaut {

// YAML with one open world and one forest, one vehicle, the planners of `labels` (all RRTConnect).
std::string small_suite_text(const std::string& name, const std::vector<std::string>& labels,
                             int repetitions = 1);

SuiteConfig small_suite(const std::string& name, const std::vector<std::string>& labels,
                        int repetitions = 1);

// A plausible result that depends on nothing but the trial's id.
TrialResult made_up_flight(const TrialSpec& spec);

// References without any search.
ShortestReferences made_up_references();

}  // namespace voronaut
