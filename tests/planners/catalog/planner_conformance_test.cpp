#include "voronaut/tests/conformance/planner_conformance.h"

#include <memory>

#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include "voronaut/planners/potential_field/potential_field.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"

namespace voronaut::test {
namespace {

template <class Planner>
ompl::base::PlannerPtr make(const ompl::base::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

ompl::base::PlannerPtr repaired(const ompl::base::SpaceInformationPtr& si) {
  auto planner = std::make_shared<ReactiveVoronoi>(si);
  planner->set_preset("repaired");
  return planner;
}

INSTANTIATE_TEST_SUITE_P(Ours, PlannerConformance,
                         testing::Values(PlannerCase{"ReactiveVoronoi_as_published",
                                                     make<ReactiveVoronoi>},
                                         PlannerCase{"ReactiveVoronoi_repaired", repaired},
                                         PlannerCase{"PotentialField", make<PotentialField>}),
                         case_name);

// Planners that are known to conform, as a check of the suite.
INSTANTIATE_TEST_SUITE_P(Ompl, PlannerConformance,
                         testing::Values(PlannerCase{"RRTConnect",
                                                     make<ompl::geometric::RRTConnect>},
                                         PlannerCase{"RRT", make<ompl::geometric::RRT>}),
                         case_name);

}  // namespace
}  // namespace voronaut::test
