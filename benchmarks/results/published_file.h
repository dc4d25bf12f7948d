#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/results/output_folder.h"
#include "voronaut/reports/summary/published_results.h"

namespace voronaut {

// Results of others on worlds of BARN: CSV with the columns method, world (its number), runs,
// successes, collisions, score (mean over the runs) and mean_time_success_s (empty where none
// arrived). Throws ConfigError with file, line and column.
std::vector<PublishedMethod> read_published(const std::string& file);

// The folder's trials beside them. Throws std::invalid_argument if no world is in both.
BarnComparison beside_published_file(const OutputFolder& folder, const std::string& file);

}  // namespace voronaut
