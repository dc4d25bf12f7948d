#pragma once

#include <algorithm>

#include "voronaut/reports/run_record.h"

namespace voronaut {

// Of who takes eight times OT or longer.
inline constexpr double kBarnScoreOfSlowest = 1.0 / 8;

// Score of one trial of the BARN challenge since 2024: arrival x OT / clip(AT, 2 OT, 8 OT), at most
// 0.5, with OT the reference path at 2 m/s and AT the time taken (the-barn-challenge, run.py). Here
// the reference is the shortest path, and AT includes the look-around before departure.
inline double barn_score(const RunRecord& record) {
  if (record.outcome != Outcome::goal_reached) return 0;
  const double optimal_s = record.shortest_length_m / 2;
  if (optimal_s == 0) return kBarnScoreOfSlowest;  // any time is more than eight times none
  return optimal_s / std::clamp(record.duration_s, 2 * optimal_s, 8 * optimal_s);
}

}  // namespace voronaut
