#pragma once

#include "voronaut/benchmarks/episode/episode_log.h"
#include "voronaut/benchmarks/trial/trial.h"

namespace voronaut {

// The log of a flight as reports draw it: one frame per scan and one at the end.
Trace trace_of(const TrialSpec& spec, const EpisodeLog& log, const ObstacleSnapshot& known);

// The world as reports draw it.
TraceWorld trace_world(const Scenario& scenario, const std::string& world_id);

}  // namespace voronaut
