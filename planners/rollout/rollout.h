#pragma once

#include <cstddef>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/environments/shapes/geometry.h"

namespace voronaut {

// A simulated motion from one start towards one goal in the plane, step by step: what a planner
// does that moves first and has its path afterwards. Each step is a valid motion.
class Rollout {
 public:
  enum class Status { running, at_goal, stuck };

  // Both states are copied.
  Rollout(const ompl::base::SpaceInformationPtr& si, const ompl::base::State* start,
          const ompl::base::State* goal);
  virtual ~Rollout() = default;

  // One step. No effect once the rollout has ended.
  void advance();

  Status status() const { return status_; }
  // The path so far; its last state is a copy of the goal if it ended there.
  const ompl::geometric::PathGeometric& path() const { return path_; }
  // The state of that path closest to the goal, and how close it is.
  std::size_t closest_index() const { return closest_index_; }
  double closest_m() const { return closest_m_; }
  const Vec2& goal_world() const { return goal_world_; }
  // Steps since it last came closer.
  std::size_t steps_without_progress() const { return steps_ - closest_step_; }

 protected:
  // Moves on with move_to() or arrive(); false: there is no way on.
  virtual bool step() = 0;

  // Both false, and nothing is changed, if the motion is not valid.
  bool move_to(const Vec2& p_world);
  bool arrive();

  const ompl::base::SpaceInformationPtr& space_information() const { return si_; }
  const Vec2& p_world() const { return p_world_; }

 private:
  ompl::base::SpaceInformationPtr si_;
  ompl::geometric::PathGeometric path_;
  ompl::geometric::PathGeometric goal_;  // one state
  Vec2 p_world_;
  Vec2 goal_world_;
  Status status_ = Status::running;
  std::size_t steps_ = 0;
  std::size_t closest_step_ = 0;
  std::size_t closest_index_ = 0;
  double closest_m_ = 0;
};

}  // namespace voronaut
