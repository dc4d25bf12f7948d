#pragma once

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/reactive_voronoi/reactive_step.h"
#include "voronaut/planners/rollout/ray_range.h"
#include "voronaut/planners/rollout/rollout.h"

// The papers' planner on a static problem: a rollout. A vehicle that knows nothing
// senses, maps, decides and moves, and its way is the path.
namespace voronaut {

// Lengths are in the units of the state space, metres elsewhere.
struct ReactiveRolloutConfig {
  double sensing_range_m = 2.5;
  double sensing_field_of_view_rad =
      1.570796326794897;  // +-45 deg about the first line to the goal
  int sensing_rays = 91;
  double ray_resolution_m = 0.05;
  double step_m = 0.1;
  int stall_steps = 300;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("sensing_range_m", sensing_range_m, 1e-3, 1e4,
             "On a static problem: the papers' range finder");
    v.number("sensing_field_of_view_rad", sensing_field_of_view_rad, 0.01, 6.283185307179586,
             "The same, about the first line to the goal");
    v.count("sensing_rays", sensing_rays, 2, 100'000, "The same");
    v.number("ray_resolution_m", ray_resolution_m, 1e-5, 100,
             "Between two states that a ray asks a plain validity checker for");
    v.number("step_m", step_m, 1e-5, 100, "Travelled between two scans");
    v.count("stall_steps", stall_steps, 1, 1'000'000,
            "So many steps without coming closer to the goal: stuck");
  }
};

class ReactiveRollout : public Rollout {
 public:
  // From a valid start to a valid goal.
  ReactiveRollout(const ompl::base::SpaceInformationPtr& si, const ReactiveVoronoiConfig& planner,
                  const ReactiveRolloutConfig& config, const ompl::base::State* start,
                  const ompl::base::State* goal);

  ReactiveMode mode() const { return mode_; }

 private:
  // One cycle: sense, map, decide, move. Stuck: the next step is not a valid motion, or no progress
  // for stall_steps.
  bool step() override;
  Vec2 decide();

  ReactiveVoronoiConfig planner_;
  ReactiveRolloutConfig config_;
  RayRange ray_range_;
  ObstacleBase base_;
  ReactiveMemory memory_;
  Scan scan_;
  ReactiveMode mode_ = ReactiveMode::none;
};

}  // namespace voronaut
