#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"

// What a suite is there to show, as bounds that its results keep or break.
namespace voronaut {

// Bounds on the trials that a claim is about. The defaults demand nothing.
struct Claim {
  std::string group;  // of scenarios; empty: any
  std::string vehicle;
  std::string planner;  // label
  Outcome outcome = Outcome::goal_reached;
  double outcome_share_min = 0;    // of all trials, failures in the denominator
  double collision_share_max = 1;  // of all trials; 0 claims that nothing was hit
  double clearance_min_m = 0;      // smallest of all trials, centre to surface
  // Over goal_reached: the way flown over the shortest one of the body, mean and 95th percentile,
  // and over the shortest one at clearance_min_m, which is all that planners may take.
  double path_ratio_mean_max = 1e6;
  double path_ratio_p95_max = 1e6;
  double path_ratio_at_clearance_mean_max = 1e6;
  // Mean speed over that of another planner (label), over the worlds that both finished.
  std::string speed_beside;
  double speed_ratio_min = 0;

  template <class Visitor>
  void visit(Visitor& v) {
    v.text("group", group);
    v.text("vehicle", vehicle);
    v.text("planner", planner);
    v.choice("outcome", outcome,
             {{"goal_reached", Outcome::goal_reached}, {"infeasible", Outcome::infeasible}});
    v.number("outcome_share_min", outcome_share_min, 0, 1);
    v.number("collision_share_max", collision_share_max, 0, 1);
    v.number("clearance_min_m", clearance_min_m, 0, 100);
    v.number("path_ratio_mean_max", path_ratio_mean_max, 1, 1e6);
    v.number("path_ratio_p95_max", path_ratio_p95_max, 1, 1e6);
    v.number("path_ratio_at_clearance_mean_max", path_ratio_at_clearance_mean_max, 0.1, 1e6);
    v.text("speed_beside", speed_beside);
    v.number("speed_ratio_min", speed_ratio_min, 0, 100);
  }
};

// Path and speed ratios are judged over at least so many arrivals; below that they are said, not
// judged.
inline constexpr std::size_t kFewestArrivals = 100;

struct Finding {
  std::string text;  // one line: about what, each bound beside what was measured
  bool holds = false;
};

// Holds only if there is a trial that the claim is about. O(records).
Finding examine(const Claim& claim, const std::vector<RunRecord>& records);

}  // namespace voronaut
