#pragma once

#include <memory>
#include <string>

#include <ompl/base/Goal.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/catalog/planner_insight.h"
#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/reactive_voronoi/reactive_rollout.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi_config.h"
#include "voronaut/planners/rollout/rollout_planner.h"

namespace voronaut {

// The planner of the papers (Finaev et al.; Soloviev et al.) as an OMPL planner for the plane.
//
// With a live belief behind the validity checker (KnownGeometry::belief()) a solve is one
// reactive_step: the path of two states is the next leg, an approximate solution unless it leads to
// the goal over known-clear ground. What it remembers is kept between solves; clear() forgets it.
//
// On a static problem a solve flies rollouts (reactive_rollout.h): the path is the way flown,
// longer than that of a planner that sees everything, and not always one that arrives.
//
// Parameters: "preset" (as_published, repaired) sets all fields of ReactiveVoronoiConfig; these and
// the fields of ReactiveRolloutConfig are parameters by their own names.
class ReactiveVoronoi : public RolloutPlanner, public PlannerInsight {
 public:
  explicit ReactiveVoronoi(const ompl::base::SpaceInformationPtr& si);

  using RolloutPlanner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  void getPlannerData(ompl::base::PlannerData& data) const override;

  std::string_view mode() const override { return to_string(mode_); }

  const ReactiveVoronoiConfig& config() const { return config_; }
  void set_config(const ReactiveVoronoiConfig& config) { config_ = config; }
  void set_preset(const std::string& name);  // throws std::invalid_argument
  std::string preset() const;                // empty if a field differs from both

 private:
  std::unique_ptr<Rollout> make_rollout(const ompl::base::State* start,
                                        const ompl::base::State* goal) override;
  ompl::base::PlannerStatus next_leg(const KnownGeometry& geometry);
  // One goal for all legs, even if the goal is a region of many; false if it cannot be sampled.
  bool choose_live_goal();

  ReactiveVoronoiConfig config_;
  ReactiveRolloutConfig rollout_config_;
  ReactiveMemory memory_;
  ReactiveMode mode_ = ReactiveMode::none;
  std::shared_ptr<ompl::geometric::PathGeometric> leg_;
  ompl::base::ScopedStatePtr live_goal_;
  const ompl::base::Goal* live_goal_of_ = nullptr;
};

}  // namespace voronaut
