#pragma once

#include "voronaut/environments/config/config_node.h"
#include "voronaut/environments/config/config_reader.h"
#include "voronaut/planners/problem/planning_budget.h"

namespace voronaut {

// The section `budget` of a suite, one of
//
//   {state_checks: 50000, ptc_evaluations: 200000}   the default
//   {iterations: 10000}
//   {wall_clock_s: 0.1}
//
// with `stop: first | budget` beside any of them. Throws ConfigError.
PlanningBudget read_budget(const ConfigNode& node);

// The same keys, those of the limit that counts only.
ConfigEntries budget_entries(const PlanningBudget& budget);

}  // namespace voronaut
