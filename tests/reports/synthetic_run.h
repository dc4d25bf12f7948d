#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/trace/trace.h"

// Records, worlds and traces that look like a suite's, made without a planner: the reports are
// tested on their own.
namespace voronaut::synthetic {

struct RunConfig {
  std::vector<std::string> planners{"repaired", "as_published", "RRTConnect"};
  std::vector<std::string> groups{"paper", "forest"};
  int scenarios_per_group = 2;
  int repetitions = 3;
  int traced_repetitions = 1;  // of each scenario and planner
  int rays = 91;
  std::uint64_t seed = 1;
};

struct Run {
  std::vector<RunRecord> records;  // ordered by trial_id
  std::vector<TraceWorld> worlds;
  std::vector<Trace> traces;
};

Run make_run(const RunConfig& config = {});

RunRecord make_record(const std::string& trial_id);
Trace make_trace(const std::string& trial_id, const TraceWorld& world, std::uint64_t seed,
                 Outcome outcome, int rays);
TraceWorld make_world(const std::string& world_id, std::uint64_t seed, int obstacles);

}  // namespace voronaut::synthetic
