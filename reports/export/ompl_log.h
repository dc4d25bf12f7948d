#pragma once

#include <string>

#include "voronaut/reports/export/planner_benchmark.h"

namespace voronaut {

// The text of a benchmark log of OMPL 1.5.2: what ompl_benchmark_statistics reads. The library that
// it names is Voronaut with our version.
std::string ompl_log(const PlannerBenchmark& benchmark);

// The planner's settings as Planner Arena stores them: each line with its end, then ';'.
std::string settings_text(const BenchmarkedPlanner& planner);

}  // namespace voronaut
