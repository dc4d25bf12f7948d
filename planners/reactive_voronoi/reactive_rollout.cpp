#include "voronaut/planners/reactive_voronoi/reactive_rollout.h"

#include <memory>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

ObstacleBaseConfig mapping_for(const ReactiveVoronoiConfig& planner) {
  ObstacleBaseConfig mapping;
  // Between two obstacles there must be room for the margin on both sides.
  mapping.merge_distance_m = 2 * planner.safety_margin_m;
  return mapping;
}

}  // namespace

ReactiveRollout::ReactiveRollout(const ob::SpaceInformationPtr& si,
                                 const ReactiveVoronoiConfig& planner,
                                 const ReactiveRolloutConfig& config, const ob::State* start,
                                 const ob::State* goal)
    : Rollout(si, start, goal),
      planner_(planner),
      config_(config),
      ray_range_(ray_range(si, start, config.ray_resolution_m)),
      base_(mapping_for(planner)) {
  const Vec2 way = goal_world() - p_world();
  if (way.squaredNorm() > 0) scan_.sensor_world.heading = way.normalized();
  scan_.max_range_m = config.sensing_range_m;
  scan_.beams = std::make_shared<BeamFan>(BeamFan::spread(
      config.sensing_field_of_view_rad, static_cast<std::size_t>(config.sensing_rays)));
}

Vec2 ReactiveRollout::decide() {
  scan_.sensor_world.p_world = p_world();
  sense(ray_range_, scan_);
  base_.update(scan_);
  const Belief belief{base_.snapshot(), &scan_, base_.scan_clusters(), scan_.sensor_world};
  const ReactiveDecision decision = reactive_step(belief, goal_world(), planner_, memory_);
  mode_ = decision.mode;
  return clamped(decision.subgoal_world, position_bounds(*space_information()->getStateSpace()));
}

bool ReactiveRollout::step() {
  if (steps_without_progress() >= static_cast<std::size_t>(config_.stall_steps)) return false;
  const Vec2 target = decide();
  const Vec2 way = target - p_world();
  const double distance_m = way.norm();
  if (distance_m > config_.step_m) return move_to(p_world() + way * (config_.step_m / distance_m));
  return mode_ == ReactiveMode::none ? arrive() : move_to(target);
}

}  // namespace voronaut
