// Every planner that Voronaut brings: the one file that knows them all.
#include <memory>
#include <utility>

#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/ompl/ompl_planners.h"
#include "voronaut/planners/potential_field/potential_field.h"
#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"
#include "voronaut/planners/voronoi/voronoi_roadmap.h"

namespace voronaut {
namespace {

template <class Planner>
ompl::base::PlannerPtr make(const ompl::base::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

}  // namespace

PlannerCatalog PlannerCatalog::built_in() {
  PlannerCatalog catalog;
  catalog.add({"PotentialField", "Khatib's artificial potential field, followed downhill",
               PlannerTraits{true, Reproducible::everywhere}, make<PotentialField>});
  catalog.add({"ReactiveVoronoi",
               "the papers' planner: past obstacles on the left, on the right, between them",
               PlannerTraits{true, Reproducible::everywhere}, make<ReactiveVoronoi>});
  catalog.add(
      {"VoronoiRoadmap",
       "the Voronoi diagram of what is known: complete at its clearance, proves \"no path\"",
       PlannerTraits{false, Reproducible::everywhere}, make<VoronoiRoadmap>});
  for (const auto& family : {tree_planners, batch_planners, roadmap_planners, parallel_planners,
                             guided_planners, experience_planners})
    for (PlannerEntry& entry : family()) catalog.add(std::move(entry));
  return catalog;
}

}  // namespace voronaut
