#pragma once

#include <string>
#include <vector>

#include "voronaut/benchmarks/tuning/search_space.h"
#include "voronaut/environments/config/config_node.h"

// The suite files that a tuning writes. They include the suite that is tuned and replace its
// planners.
namespace voronaut {

// A setting of the planner's keys.
struct Candidate {
  std::string label;
  std::vector<std::string> values;  // by key; empty: as the suite has it
};

// The first is the planner as the suite has it, by its own label, the others "LABEL-1" ... with the
// points.
std::vector<Candidate> candidates_of(const std::string& planner,
                                     const std::vector<std::vector<std::string>>& points);

// The entry of a planner by its label in the root of a suite. Throws std::invalid_argument.
ConfigNode planner_entry(const ConfigNode& root, const std::string& label);

// Flies the candidates instead of the suite's planners. `file` is absolute.
std::string candidates_suite(const ConfigNode& root, const std::string& file,
                             const std::string& planner, const std::vector<SearchKey>& keys,
                             const std::vector<Candidate>& candidates);

// The suite with its planner at the values of the winner; what is said of it goes into the first
// line.
std::string winners_suite(const ConfigNode& root, const std::string& file,
                          const std::string& planner, const std::vector<SearchKey>& keys,
                          const Candidate& winner, const std::string& said);

}  // namespace voronaut
