#pragma once

#include "voronaut/reports/run_record.h"

namespace voronaut {

// path_ratio against the shortest path at clearance_min_m instead of that of the body: what a
// planner that keeps the clearance could have done at best. Below 1 only for a vehicle that came
// closer. NaN where path_ratio is, or where no path has that clearance; path_ratio where start and
// goal are one place, as then are the references.
inline double path_ratio_at_clearance(const RunRecord& record) {
  if (record.shortest_at_clearance_m == 0) return record.path_ratio;
  return record.path_ratio * record.shortest_length_m / record.shortest_at_clearance_m;
}

}  // namespace voronaut
