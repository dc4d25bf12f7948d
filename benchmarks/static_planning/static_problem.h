#pragma once

#include <cstdint>
#include <memory>

#include "voronaut/environments/scenario/scenario.h"
#include "voronaut/planners/problem/problem.h"

namespace voronaut {

// A scenario as a static problem for OMPL: states and motions are exact against the true shapes at
// planning_clearance_m > 0. Planners see the world through the space information's validity checker
// and motion validator alone. The scenario must outlive it.
class StaticProblem {
 public:
  StaticProblem(const Scenario& scenario, double planning_clearance_m);
  ~StaticProblem();

  const ompl::base::SpaceInformationPtr& space_information() const {
    return problem_.space_information();
  }
  const ompl::base::ProblemDefinitionPtr& definition() const { return problem_.definition(); }
  std::uint64_t state_checks() const;  // states and motions checked so far

  // What a path is judged by. Of a problem that no planner was given: theirs may be changed.
  const PathRequest& request() const { return problem_.request(); }
  const KnownGeometry& truth() const;

 private:
  class Truth;

  std::shared_ptr<Truth> truth_;
  PlanningProblem problem_;
};

}  // namespace voronaut
