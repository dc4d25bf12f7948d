#pragma once

#include <vector>

#include "voronaut/dynamics/path.h"
#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Where the vehicle has been, so that it can go back. A vehicle may come through a passage a little
// narrower than planners plan for, before its sides are known; from the pocket behind it no planner
// finds a way on or back, although there is one from where the mission began.
class WayFlown {
 public:
  // Marks are this far apart; going back ends this close to one.
  static constexpr double kSpacing_m = 0.1;

  // At p now, on the way out: a mark is left whenever the last one is kSpacing_m away. O(1).
  void go_on(const Vec2& p_world);
  // At p now, on the way back: forgets the marks that are reached or passed. O(their number).
  void go_back(const Vec2& p_world);

  // From p over the latest marks backwards, leg_m long or as far as there are marks; empty if there
  // are none. O(marks on it).
  Path back_from(const Vec2& p_world, double leg_m) const;

 private:
  std::vector<Vec2> marks_world_;
};

}  // namespace voronaut
