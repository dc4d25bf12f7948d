#include "voronaut/tests/conformance/planner_conformance.h"

#include <memory>

#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/RandomNumbers.h>

#include "voronaut/planners/potential_field/potential_field.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"
#include "voronaut/planners/voronoi/voronoi_roadmap.h"

namespace voronaut::test {
namespace {

// OMPL seeds itself from the clock, and a planner that samples fails a test now and then.
class OneSeed : public ::testing::Environment {
 public:
  void SetUp() override { ompl::RNG::setSeed(1); }
};
[[maybe_unused]] const auto* const kOneSeed = ::testing::AddGlobalTestEnvironment(new OneSeed);

template <class Planner>
ompl::base::PlannerPtr make(const ompl::base::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

ompl::base::PlannerPtr repaired(const ompl::base::SpaceInformationPtr& si) {
  auto planner = std::make_shared<ReactiveVoronoi>(si);
  planner->set_preset("repaired");
  return planner;
}

// Each in the plane and in SE(2).
std::vector<PlannerCase> in_both_spaces(std::vector<PlannerCase> cases) {
  const std::size_t count = cases.size();
  for (std::size_t i = 0; i < count; ++i)
    cases.push_back({cases[i].name + "_se2", cases[i].make, Space::se2});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(
    Ours, PlannerConformance,
    testing::ValuesIn(in_both_spaces({{"ReactiveVoronoi_as_published", make<ReactiveVoronoi>},
                                      {"ReactiveVoronoi_repaired", repaired},
                                      {"VoronoiRoadmap", make<VoronoiRoadmap>},
                                      {"PotentialField", make<PotentialField>}})),
    case_name);

// Planners that are known to conform, as a check of the suite.
INSTANTIATE_TEST_SUITE_P(
    Ompl, PlannerConformance,
    testing::ValuesIn(in_both_spaces({{"RRTConnect", make<ompl::geometric::RRTConnect>},
                                      {"RRTstar", make<ompl::geometric::RRTstar>}})),
    case_name);

}  // namespace
}  // namespace voronaut::test
