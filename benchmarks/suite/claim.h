#pragma once

#include <string>
#include <vector>

#include "voronaut/reports/run_record.h"

// What a suite is there to show, as bounds that its results keep or break.
namespace voronaut {

// Bounds on the trials that a claim is about. The defaults demand nothing.
struct Claim {
  std::string group;
  std::string vehicle;
  std::string planner;
  Outcome outcome = Outcome::goal_reached;
  double outcome_share_min = 0;
  double collision_share_max = 1;
  double clearance_min_m = 0;  // smallest of all trials, centre to surface
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
    v.text("group", group, "Only scenarios of this group; nothing: any");
    v.text("vehicle", vehicle, "Only this vehicle, by label; nothing: any");
    v.text("planner", planner, "Only this planner, by label; nothing: any");
    v.choice("outcome", outcome,
             {{"goal_reached", Outcome::goal_reached}, {"infeasible", Outcome::infeasible}},
             "What outcome_share_min is about");
    v.number("outcome_share_min", outcome_share_min, 0, 1,
             "Smallest share of all trials with this outcome, failures in the denominator");
    v.number("collision_share_max", collision_share_max, 0, 1,
             "Largest share of all trials that hit something");
    v.number("clearance_min_m", clearance_min_m, 0, 100,
             "Smallest clearance flown in any trial, centre to surface");
    v.number("path_ratio_mean_max", path_ratio_mean_max, 1, 1e6,
             "Largest mean, over arrivals, of the way flown over the body's shortest one");
    v.number("path_ratio_p95_max", path_ratio_p95_max, 1, 1e6, "The same of the 95th percentile");
    v.number("path_ratio_at_clearance_mean_max", path_ratio_at_clearance_mean_max, 0.1, 1e6,
             "The same of the mean over the shortest way at planning_clearance_m");
    v.text("speed_beside", speed_beside,
           "Another planner, by label, whose mean speed is compared with over worlds that both "
           "finished");
    v.number("speed_ratio_min", speed_ratio_min, 0, 100,
             "Smallest ratio of the mean speed to that of speed_beside");
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
