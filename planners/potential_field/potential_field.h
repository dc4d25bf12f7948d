#pragma once

#include <memory>

#include "voronaut/planners/potential_field/descent.h"
#include "voronaut/planners/rollout/rollout_planner.h"

namespace voronaut {

// The artificial potential field (potential.h) as an OMPL planner for the plane: the path is the
// descent from the start. Where it ends in a local minimum the solution is approximate.
//
// With a live belief behind the validity checker every solve begins anew at the start of the
// problem, so the vehicle follows the field of what is known at each scan.
//
// The fields of PotentialConfig and DescentConfig are parameters by their own names.
class PotentialField : public RolloutPlanner {
 public:
  explicit PotentialField(const ompl::base::SpaceInformationPtr& si);

  using RolloutPlanner::solve;
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;

 private:
  std::unique_ptr<Rollout> make_rollout(const ompl::base::State* start,
                                        const ompl::base::State* goal) override;
  // The whole descent: it may lead away from the goal for a while.
  std::size_t end_of_approximation(const Rollout& rollout) const override;

  PotentialConfig potential_config_;
  DescentConfig descent_config_;
};

}  // namespace voronaut
