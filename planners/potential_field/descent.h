#pragma once

#include <vector>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/potential_field/potential.h"
#include "voronaut/planners/rollout/ray_range.h"
#include "voronaut/planners/rollout/rollout.h"

namespace voronaut {

// Lengths are in the units of the state space, metres elsewhere.
struct DescentConfig {
  double step_m = 0.05;
  double smallest_step_m = 0.001;
  int stall_steps = 400;
  int sensing_rays = 90;
  double ray_resolution_m = 0.05;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("step_m", step_m, 1e-5, 100, "Length of a step downhill");
    v.number("smallest_step_m", smallest_step_m, 1e-9, 100,
             "No lower potential within so much: a local minimum");
    v.count("stall_steps", stall_steps, 1, 1'000'000,
            "So many steps without coming closer to the goal: the same");
    v.count("sensing_rays", sensing_rays, 3, 100'000,
            "About a plain validity checker: rays over the full circle");
    v.number("ray_resolution_m", ray_resolution_m, 1e-5, 100,
             "About a plain validity checker: between two states that a ray asks for");
  }
};

// Steepest descent of the total potential, by steps that are halved until the potential falls, so
// it ends: at the goal, in a local minimum, or where no step is a valid motion. The obstacles are
// the known ones of a KnownGeometry, all at once; behind any other validity checker they are sensed
// on the way, at each step as far as they push. O(known points) per step.
class Descent : public Rollout {
 public:
  Descent(const ompl::base::SpaceInformationPtr& si, const PotentialConfig& potential,
          const DescentConfig& config, const ompl::base::State* start,
          const ompl::base::State* goal);

 private:
  bool step() override;
  void look_around();
  // Of each obstacle within the influence distance the closest point, into closest_.
  void find_closest(const Vec2& p);
  double potential_at(const Vec2& p);

  PotentialConfig potential_;
  DescentConfig config_;
  RayRange ray_range_;  // empty where the obstacles are known
  ObstacleBase sensed_;
  Scan scan_;
  ObstacleSnapshot obstacles_;
  std::vector<Vec2> closest_;
  std::vector<ClusterId> closest_cluster_;
};

}  // namespace voronaut
