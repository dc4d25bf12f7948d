#include "voronaut/planners/reactive_voronoi/mission.h"

#include <ompl/base/ScopedState.h>

#include "voronaut/planners/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// Progress smaller than this is none.
constexpr double kProgress_m = 1e-3;

ObstacleBaseConfig mapping_for(const ReactiveVoronoiConfig& planner) {
  ObstacleBaseConfig mapping;
  // What the vehicle keeps its margin to on both sides must be wider than both margins.
  mapping.merge_distance_m = 2 * planner.safety_margin_m;
  return mapping;
}

}  // namespace

Mission::Mission(const ob::SpaceInformationPtr& si, const ReactiveVoronoiConfig& planner,
                 const MissionConfig& config, const ob::State* start, const ob::State* goal)
    : si_(si),
      planner_(planner),
      config_(config),
      ray_range_(ray_range(si, start, config.ray_resolution_m)),
      base_(mapping_for(planner)),
      goal_world_(position_of(*si->getStateSpace(), goal)),
      executed_(std::make_shared<og::PathGeometric>(si, start)),
      goal_(std::make_shared<og::PathGeometric>(si, goal)) {
  const Vec2 start_world = position_of(*si->getStateSpace(), start);
  const Vec2 way = goal_world_ - start_world;
  closest_m_ = way.norm();
  scan_.sensor_world.p_world = start_world;
  if (closest_m_ > 0) scan_.sensor_world.heading = way / closest_m_;
  scan_.max_range_m = config.sensing_range_m;
  scan_.beams = std::make_shared<BeamFan>(BeamFan::spread(
      config.sensing_field_of_view_rad, static_cast<std::size_t>(config.sensing_rays)));
  scan_.range_m.resize(scan_.beams->direction_sensor.size());
}

Vec2 Mission::decide() {
  for (std::size_t i = 0; i < scan_.size(); ++i)
    scan_.range_m[i] =
        ray_range_(scan_.sensor_world.p_world, scan_.direction_world(i), scan_.max_range_m);
  base_.update(scan_);
  const Belief belief{base_.snapshot(), &scan_, base_.scan_clusters(), scan_.sensor_world};
  const ReactiveDecision decision = reactive_step(belief, goal_world_, planner_, memory_);
  mode_ = decision.mode;
  return clamped(decision.subgoal_world, position_bounds(*si_->getStateSpace()));
}

bool Mission::move_to(const Vec2& target) {
  const Vec2 here = scan_.sensor_world.p_world;
  const Vec2 way = target - here;
  const double distance_m = way.norm();
  const bool arrives = mode_ == ReactiveMode::none && distance_m <= config_.step_m;
  const ob::State* last = executed_->getStates().back();
  if (arrives) {
    if (!si_->checkMotion(last, goal_->getState(0))) return false;
    executed_->append(goal_->getState(0));
    status_ = Status::at_goal;
    closest_m_ = 0;
    closest_index_ = executed_->getStateCount() - 1;
    return true;
  }
  const Vec2 next =
      distance_m <= config_.step_m ? target : Vec2(here + way * (config_.step_m / distance_m));
  ob::ScopedState<> state(si_);
  si_->copyState(state.get(), last);
  set_position(*si_->getStateSpace(), state.get(), next);
  if (!si_->checkMotion(last, state.get())) return false;
  executed_->append(state.get());
  scan_.sensor_world.p_world = next;
  return true;
}

Mission::Status Mission::advance() {
  if (status_ != Status::under_way) return status_;
  if (!move_to(decide())) return status_ = Status::stuck;
  if (status_ == Status::at_goal) return status_;
  const double goal_m = (goal_world_ - scan_.sensor_world.p_world).norm();
  ++steps_without_progress_;
  if (goal_m < closest_m_ - kProgress_m) {
    closest_m_ = goal_m;
    closest_index_ = executed_->getStateCount() - 1;
    steps_without_progress_ = 0;
  }
  if (steps_without_progress_ >= config_.stall_steps) status_ = Status::stuck;
  return status_;
}

}  // namespace voronaut
