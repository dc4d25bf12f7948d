#pragma once

#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// A trial of a suite of kind `static`: the whole true world is given and nobody moves, as in
// ompl::tools::Benchmark. States and motions are exact against the true shapes at the vehicle's
// planning_clearance_m; planners see them through the validity checker and motion validator alone.
// Two solves: the first, of a problem and with a seed of its own, takes the page faults of a new
// process out of the second, which is seeded anew and measured. Who crashes in either has crashed.
// In the row:
//
//   outcome         goal_reached: a path to the goal that is clear, judged by a problem of its own
//                   that no planner was given (path_request.h); collision: one that is not;
//                   infeasible: proved; invalid: start or goal; timeout: no path, or one that leads
//                   elsewhere
//   path_*, spl     of the path found; clearance_* at its vertices
//   planning_time_us_mean   wall time of solve()
//   state_digest    over the vertices of the path
//
// A trace walks along the path at 1 m/s, and holds what the planner searched and its improvements.
//
// Seeds OMPL: in a process of its own, as run_trial().
TrialResult run_static_trial(const TrialSpec& spec, const PlannerCatalog& planners,
                             bool keep_trace);

}  // namespace voronaut
