#pragma once

#include <vector>

#include "voronaut/dynamics/path.h"
#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// Where the vehicle has been, so that it can go back. A vehicle may come through a passage a little
// narrower than planners plan for, before its sides are known; from the pocket behind it no planner
// finds a way on or back, although there is one from where the mission began.
class BreadcrumbTrail {
 public:
  // Crumbs are this far apart; going back ends this close to one.
  static constexpr double kSpacing_m = 0.1;

  // At p now, on the way out: a crumb is left whenever the last one is kSpacing_m away. O(1).
  void extend(const Vec2& p_world);
  // At p now, on the way back: forgets the crumbs that are reached or passed. O(their number).
  void backtrack(const Vec2& p_world);

  // From p over the latest crumbs backwards, length_m long or as far as there are crumbs; empty if
  // there are none. O(crumbs on it).
  Path path_back(const Vec2& p_world, double length_m) const;

 private:
  std::vector<Vec2> crumbs_world_;
};

}  // namespace voronaut
