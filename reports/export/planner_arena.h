#pragma once

#include <filesystem>

#include "voronaut/reports/export/planner_benchmark.h"

namespace voronaut {

// The SQLite database that Planner Arena loads, equal table by table to what OMPL 1.5.2's
// ompl_benchmark_statistics makes of ompl_log(). Planner Arena reads by position: the first 12
// columns of experiments and the first 3 of runs keep their order. Replaces the file. Throws
// StoreError.
void write_planner_arena(const PlannerBenchmark& benchmark, const std::filesystem::path& file);

}  // namespace voronaut
