#pragma once

#include <span>

#include "voronaut/reports/summary/summary.h"

// Who is better than whom in a group, as far as paired trials can tell.
namespace voronaut {

inline constexpr double kRankLevel = 0.05;

// Fills in PlannerPairing::success_p_holm and path_p_holm and PlannerSummary::rank of one group:
// `planners` and all of their `pairings`. Two exact tests a pair (mcnemar_exact), on who reached
// the goal, and on whose path is shorter where both did; Holm's correction over all tests of the
// group. Planners without a common trial cannot be told apart.
void rank_planners(std::span<PlannerSummary> planners, std::span<PlannerPairing> pairings);

// 1 if planner_a is better, -1 if planner_b is, 0 where the data cannot tell: who reaches the goal
// significantly more often; where that is undecided, whose path is significantly more often the
// shorter one.
int better_of(const PlannerPairing& pairing);

}  // namespace voronaut
