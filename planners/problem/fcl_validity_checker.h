#pragma once

#include <memory>

#include <ompl/base/StateValidityChecker.h>

#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/start_relaxation.h"

namespace voronaut {

// The same questions as BeliefValidityChecker, answered by the Flexible Collision Library (Pan,
// Chitta, Manocha 2012, doi 10.1109/ICRA.2012.6225337): an independent second opinion that shares
// no distance computation with the cell list. Known points are spheres of kPointRadius_m, the disc
// a sphere and the swept disc a capsule with the clearance less that radius. Where the two differ,
// the clearance is within kTolerance_m of the limit. A relaxed clearance of less than
// kPointRadius_m always holds. Slower by far; one thread.
class FclValidityChecker : public ompl::base::StateValidityChecker, public KnownGeometry {
 public:
  static constexpr double kPointRadius_m = 0.01;
  static constexpr double kTolerance_m = 1e-6;

  // planning_clearance_m > kPointRadius_m.
  FclValidityChecker(const ompl::base::SpaceInformationPtr& si, double planning_clearance_m);
  ~FclValidityChecker() override;

  // As BeliefValidityChecker::look_at() on a static problem. O(points log points).
  void look_at(const ObstacleSnapshot& obstacles, const Vec2& start_world);

  bool isValid(const ompl::base::State* state) const override;
  // Distance to the closest known point [m], 0 within kPointRadius_m of it; the diagonal of the
  // bounds if there is none nearer.
  double clearance(const ompl::base::State* state) const override;
  using StateValidityChecker::clearance;

  const ObstacleSnapshot& known_obstacles() const override { return obstacles_; }
  double planning_clearance_m() const override { return planning_clearance_m_; }
  bool motion_is_clear(const Vec2& a, const Vec2& b) const override;
  const Belief* belief() const override { return nullptr; }

 private:
  struct Scene;

  double clearance_m(const Vec2& p) const;

  double planning_clearance_m_;
  ObstacleSnapshot obstacles_;
  StartRelaxation relaxation_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace voronaut
