#pragma once

#include <memory>
#include <string>
#include <vector>

#include "voronaut/planners/catalog/catalog.h"

// Every geometric planner of OMPL 1.5.2 under its own name, one list per family.
//
// `reproducible` is what tests/benchmarks/catalog/every_planner_test holds: the same bits from two
// processes, one of them with the FMA forms of its C library masked.
namespace voronaut {

std::vector<PlannerEntry> tree_planners();        // grow one or two trees of motions
std::vector<PlannerEntry> batch_planners();       // order a batch of samples: fast marching, BIT*
std::vector<PlannerEntry> roadmap_planners();     // PRM, SPARS and a PRM without threads
std::vector<PlannerEntry> parallel_planners();    // several planners or threads at once
std::vector<PlannerEntry> guided_planners();      // want more than a space: a field, a task space
std::vector<PlannerEntry> experience_planners();  // answer from paths that they have found before

// Planners that improve a path until they are stopped, and do not say so in their specs.
template <class Planner>
class Anytime : public Planner {
 public:
  explicit Anytime(const ompl::base::SpaceInformationPtr& si) : Planner(si) {
    this->specs_.optimizingPaths = true;
  }
};

template <class Planner>
PlannerEntry ompl_entry(const char* name, const char* summary,
                        Reproducible reproducible = Reproducible::everywhere) {
  return {name, std::string("OMPL: ") + summary, PlannerTraits{.reproducible = reproducible},
          [](const ompl::base::SpaceInformationPtr& si) -> ompl::base::PlannerPtr {
            return std::make_shared<Planner>(si);
          }};
}

}  // namespace voronaut
