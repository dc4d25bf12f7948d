#include "voronaut/planners/rollout/rollout.h"

#include <ompl/base/ScopedState.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

// Coming closer by less is no progress.
constexpr double kProgress_m = 1e-3;

}  // namespace

Rollout::Rollout(const ob::SpaceInformationPtr& si, const ob::State* start, const ob::State* goal)
    : si_(si),
      path_(si, start),
      goal_(si, goal),
      p_world_(position_of(*si->getStateSpace(), start)),
      goal_world_(position_of(*si->getStateSpace(), goal)),
      closest_m_((goal_world_ - p_world_).norm()) {}

void Rollout::advance() {
  if (status_ != Status::running) return;
  ++steps_;
  if (!step()) {
    status_ = Status::stuck;
    return;
  }
  const double goal_m = status_ == Status::at_goal ? 0 : (goal_world_ - p_world_).norm();
  if (goal_m < closest_m_ - kProgress_m || status_ == Status::at_goal) {
    closest_m_ = goal_m;
    closest_index_ = path_.getStateCount() - 1;
    closest_step_ = steps_;
  }
}

bool Rollout::move_to(const Vec2& p_world) {
  const ob::State* last = path_.getStates().back();
  ob::ScopedState<> next(si_);
  si_->copyState(next.get(), last);
  set_position(*si_->getStateSpace(), next.get(), p_world);
  if (!si_->checkMotion(last, next.get())) return false;
  path_.append(next.get());
  p_world_ = p_world;
  return true;
}

bool Rollout::arrive() {
  if (!si_->checkMotion(path_.getStates().back(), goal_.getState(0))) return false;
  path_.append(goal_.getState(0));
  p_world_ = goal_world_;
  status_ = Status::at_goal;
  return true;
}

}  // namespace voronaut
