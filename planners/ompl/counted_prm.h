#pragma once

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/geometric/planners/prm/PRM.h>

namespace voronaut {

// OMPL's probabilistic roadmap (Kavraki et al. 1996, doi 10.1109/70.508439) with its own sampling,
// connection and search, but no thread and no clock: OMPL's form grows for 0.2 s and expands for
// 0.1 s in turn while a second thread looks for a path every millisecond. This one takes turns by
// evaluations of the termination condition in the same proportion and looks in between.
// The same parameters as PRM.
class CountedPrm : public ompl::geometric::PRM {
 public:
  explicit CountedPrm(const ompl::base::SpaceInformationPtr& si);

  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& ptc) override;

 private:
  bool take_in_starts();
  bool take_in_goals(const ompl::base::GoalSampleableRegion& goal,
                     const ompl::base::PlannerTerminationCondition& ptc);
  ompl::base::PlannerStatus publish(const ompl::base::PathPtr& exact);
};

}  // namespace voronaut
