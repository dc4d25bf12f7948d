#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>

#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/start_relaxation.h"

namespace voronaut {

// A state is valid if the vehicle's centre lies within the space's bounds and no known point is
// closer than planning_clearance_m (relaxed around a start that is too close already). Exact: no
// step size. Before the first look_at() nothing is known and everything within bounds is free.
//
// Queries cost O(points near the disc or the swept disc) and may come from several threads;
// checks() may then miss a few.
class BeliefValidityChecker : public ompl::base::StateValidityChecker, public KnownGeometry {
 public:
  // The space must be one that position_of() (planar_state.h) can read.
  BeliefValidityChecker(const ompl::base::SpaceInformationPtr& si, double planning_clearance_m);

  // What is known from now on, seen from this start. The belief must stay alive until the next
  // call. Never during a solve.
  void look_at(const Belief& belief, const Vec2& start_world);
  // The same for a static problem: no vehicle is under way, belief() is null.
  void look_at(const ObstacleSnapshot& obstacles, const Vec2& start_world);

  // From the next look_at() on.
  void keep(double planning_clearance_m) { planning_clearance_m_ = planning_clearance_m; }

  bool isValid(const ompl::base::State* state) const override;
  // Distance to the closest known point [m]; the diagonal of the bounds if there is none nearer.
  double clearance(const ompl::base::State* state) const override;
  using StateValidityChecker::clearance;

  const ObstacleSnapshot& known_obstacles() const override { return obstacles_; }
  double planning_clearance_m() const override { return planning_clearance_m_; }
  bool motion_is_clear(const Vec2& a, const Vec2& b) const override;
  const Belief* belief() const override { return belief_; }

  // States and motions put to this checker since it was made, each counted once.
  std::uint64_t checks() const { return checks_.load(std::memory_order_relaxed); }
  // Forgets the checks made since checks() was this.
  void count_again_from(std::uint64_t checks) { checks_.store(checks, std::memory_order_relaxed); }

 private:
  double clearance_m(const Vec2& p) const;

  double planning_clearance_m_;
  double horizon_m_;
  ObstacleSnapshot obstacles_;
  const Belief* belief_ = nullptr;
  StartRelaxation relaxation_;
  // Two plain instructions instead of a locked one, as this is the innermost loop of every planner.
  void count() const { checks_.store(checks() + 1, std::memory_order_relaxed); }
  mutable std::atomic<std::uint64_t> checks_ = 0;
};

}  // namespace voronaut
