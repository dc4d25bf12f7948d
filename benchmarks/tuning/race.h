#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/estimate.h"
#include "voronaut/reports/summary/statistics.h"

// Which candidates go on: successive halving (Jamieson and Talwalkar, AISTATS 2016,
// https://proceedings.mlr.press/v51/jamieson16.html) with paired racing in between (F-Race:
// Birattari, Stuetzle, Paquete and Varrentrapp, GECCO 2002).
namespace voronaut {

// What a tuning is for: "success", the name of a statistic, or of a column that one is over. Throws
// std::invalid_argument for another, for one without a better way, and for measured times, which
// would make the winner a matter of chance.
const Statistic& objective(const std::string& name);

struct Standing {
  std::string planner;
  // Mean rank among those that still fly, 0 the best, 1 the worst, over objectives and blocks:
  // trials of one scenario, repetition and vehicle, which meet the same world. What has no value,
  // as a path ratio without an arrival, ranks last.
  double score = 0;
  Estimate behind_leader;  // score minus the leader's, bootstrapped over worlds
  bool kept = false;
};

// The candidates by score, ties in the order of `planners`, so the first is the leader. Kept are at
// most `most`; of them not those whose interval lies behind the leader. `records` has a row of each
// candidate in each block. O(resamples * rows).
std::vector<Standing> race(const std::vector<std::string>& planners,
                           const std::vector<const Statistic*>& objectives,
                           const std::vector<RunRecord>& records, std::size_t most);

struct Rung {
  std::size_t candidates = 0;
  int repetitions = 0;
};
// Half of the candidates go on from each rung, to twice the repetitions, so that two fly all.
std::vector<Rung> rungs(std::size_t candidates, int repetitions);

}  // namespace voronaut
