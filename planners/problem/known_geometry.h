#pragma once

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/problem/belief.h"

namespace voronaut {

// What a validity checker may offer beyond isValid(): the exact geometry behind it. Planners of
// ours look for it with a dynamic_cast of the space information's checker, and sense through
// isValid() where it is missing.
class KnownGeometry {
 public:
  virtual ~KnownGeometry() = default;

  virtual const ObstacleSnapshot& known_obstacles() const = 0;
  virtual double planning_clearance_m() const = 0;
  // Exact swept disc of radius planning_clearance_m against the known obstacles, with the
  // relaxation around a start that is too close to an obstacle already.
  virtual bool motion_is_clear(const Vec2& a, const Vec2& b) const = 0;
  // The live belief of a vehicle under way, or null for a static problem.
  virtual const Belief* belief() const = 0;
};

}  // namespace voronaut
