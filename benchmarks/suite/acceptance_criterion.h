#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "voronaut/reports/summary/statistics.h"

// What a suite is there to show, as bounds that its results keep or break.
namespace voronaut {

// A bound that a criterion may set: the name of a statistic with _min where more of it is better,
// _max where less is, either where neither is.
struct AcceptanceBound {
  std::string key;
  const Statistic* statistic = nullptr;
  bool is_min = false;
  double largest = 1;  // of the value; 0 is the smallest

  // Where the bound demands nothing.
  double idle() const { return is_min ? 0 : largest; }
};

// Every bound there is, in the order of statistics().
const std::vector<AcceptanceBound>& acceptance_bounds();

struct AcceptanceCriterion {
  std::string group;  // of scenarios; empty: any
  std::string vehicle;
  std::string planner;         // label
  std::vector<double> bounds;  // in the order of acceptance_bounds()
  // Mean speed over that of another planner (label), over the worlds that both finished.
  std::string speed_beside;
  double speed_ratio_min = 0;
  double speed_ratio_lower_min = 0;  // of the lower end of its 95 % interval

  AcceptanceCriterion();
  // By its key; std::invalid_argument for an unknown one.
  double& bound(std::string_view key);

  template <class Visitor>
  void visit(Visitor& v) {
    v.text("group", group, "Only scenarios of this group; nothing: any");
    v.text("vehicle", vehicle, "Only this vehicle, by label; nothing: any");
    v.text("planner", planner, "Only this planner, by label; nothing: any");
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const AcceptanceBound& bound = acceptance_bounds()[i];
      v.number(bound.key, bounds[i], 0, bound.largest, description_of(*bound.statistic));
    }
    v.text("speed_beside", speed_beside,
           "Another planner, by label, whose mean speed is compared with over worlds that both "
           "finished");
    v.number("speed_ratio_min", speed_ratio_min, 0, 100,
             "Smallest ratio of the mean speed to that of speed_beside");
    v.number("speed_ratio_lower_min", speed_ratio_lower_min, 0, 100,
             "And the lower end of its 95 % interval is at least this");
  }
};

// Statistics over trials that reached the goal, and speed ratios, are judged over at least so many
// of them; below that they are said, not judged.
inline constexpr std::int64_t kFewestArrivals = 100;

struct Finding {
  std::string text;  // one line: about what, each bound beside what was measured
  bool holds = false;
};

// Holds only if there is a trial that the criterion is about. O(records).
Finding examine(const AcceptanceCriterion& criterion, const std::vector<RunRecord>& records);

// All criteria of a suite, a line each; holds if every one does. One about a planner that is not
// among those `flying` and has no record was left out and is not judged. O(criteria * records).
Finding examine_all(const std::vector<AcceptanceCriterion>& criteria,
                    const std::vector<std::string>& flying, const std::vector<RunRecord>& records);

}  // namespace voronaut
