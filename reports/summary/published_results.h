#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"
#include "voronaut/reports/summary/estimate.h"

// Results that others published on the worlds of the BARN challenge, and ours beside them: over the
// worlds that both met, paired by world. Pure functions; the same input gives the same bits.
namespace voronaut {

// What one method did on one world.
struct PublishedWorld {
  std::string scenario;  // as ours is called: "barn_006"
  std::int64_t runs = 0;
  std::int64_t successes = 0;
  std::int64_t collisions = 0;
  double score = kAbsent;   // mean over the runs, by the rule of episode/barn_challenge.h
  double time_s = kAbsent;  // mean over the successes
};

struct PublishedMethod {
  std::string name;
  std::vector<PublishedWorld> worlds;
};

// One row of the table, theirs or ours.
struct BarnStanding {
  std::string name;     // of the method, or the planner's label
  std::string vehicle;  // empty: theirs
  std::int64_t worlds = 0;
  Estimate reached, collided;  // over runs
  Estimate score;              // of the worlds' means; bootstrap over worlds
  Estimate time_s;             // likewise, over worlds where it arrived
};

struct BarnDifference {
  std::string planner, vehicle, method;
  std::int64_t worlds = 0;
  Estimate score;           // ours less theirs, mean over worlds; bootstrap over worlds
  double p = kAbsent;       // two-sided, bootstrapped
  double p_holm = kAbsent;  // corrected over all differences
};

struct BarnComparison {
  std::int64_t worlds = 0;              // that all have met
  std::vector<BarnStanding> standings;  // by score, the best first
  std::vector<BarnDifference> differences;
};

// Records without a barn_score are passed over. No world that all have met leaves both lists empty.
BarnComparison beside_published(const std::vector<RunRecord>& records,
                                const std::vector<PublishedMethod>& methods,
                                const BootstrapConfig& bootstrap = {.resamples = 10'000});

std::string barn_text(const BarnComparison& comparison);
std::string barn_markdown(const BarnComparison& comparison);
// {"worlds", "standings": [{name, vehicle, worlds, reached, collided, score, time_s}],
// "differences": [{planner, vehicle, method, worlds, score, p, p_holm}]}; an estimate is {"value",
// "interval": [low, high], "n"}, of a share with "successes", null where absent.
std::string barn_json(const BarnComparison& comparison);

}  // namespace voronaut
