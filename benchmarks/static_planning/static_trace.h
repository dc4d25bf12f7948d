#pragma once

#include <vector>

#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/dynamics/path.h"
#include "voronaut/planners/problem/planning_budget.h"

namespace voronaut {

// A static plan as a trace that can be replayed: a body walks along the path at 1 m/s, seeing
// nothing; `searched` is what the planner looked at. One frame, at the start, for an empty path;
// one each 0.05 s else, and at most kMostStaticFrames.
inline constexpr int kMostStaticFrames = 20'000;
Trace static_trace(const TrialSpec& spec, const Path& path,
                   const std::vector<Improvement>& improvements,
                   const std::vector<Segment>& searched);

}  // namespace voronaut
