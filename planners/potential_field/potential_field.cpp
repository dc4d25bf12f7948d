#include "voronaut/planners/potential_field/potential_field.h"

#include "voronaut/planners/catalog/parameter_declaration.h"
#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

namespace ob = ompl::base;

PotentialField::PotentialField(const ob::SpaceInformationPtr& si)
    : TravelPlanner(si, "PotentialField") {
  ParameterDeclaration declaration(params_);
  potential_config_.visit(declaration);
  descent_config_.visit(declaration);
}

ob::PlannerStatus PotentialField::solve(const ob::PlannerTerminationCondition& ptc) {
  const auto* geometry = dynamic_cast<const KnownGeometry*>(si_->getStateValidityChecker().get());
  if (geometry && geometry->belief()) {
    forget_travels();
    pis_.restart();
  }
  return TravelPlanner::solve(ptc);
}

std::unique_ptr<Travel> PotentialField::travel(const ob::State* start, const ob::State* goal) {
  return std::make_unique<Descent>(si_, potential_config_, descent_config_, start, goal);
}

std::size_t PotentialField::end_of_approximation(const Travel& travel) const {
  return travel.way().getStateCount() - 1;
}

}  // namespace voronaut
