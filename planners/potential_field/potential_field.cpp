#include "voronaut/planners/potential_field/potential_field.h"

#include "voronaut/planners/catalog/parameter_declaration.h"
#include "voronaut/planners/problem/known_geometry.h"

namespace voronaut {

namespace ob = ompl::base;

PotentialField::PotentialField(const ob::SpaceInformationPtr& si)
    : RolloutPlanner(si, "PotentialField") {
  ParameterDeclaration declaration(params_);
  potential_config_.visit(declaration);
  descent_config_.visit(declaration);
}

ob::PlannerStatus PotentialField::solve(const ob::PlannerTerminationCondition& ptc) {
  const auto* geometry = dynamic_cast<const KnownGeometry*>(si_->getStateValidityChecker().get());
  if (geometry && geometry->belief()) {
    forget_rollouts();
    pis_.restart();
  }
  return RolloutPlanner::solve(ptc);
}

std::unique_ptr<Rollout> PotentialField::make_rollout(const ob::State* start,
                                                      const ob::State* goal) {
  return std::make_unique<Descent>(si_, potential_config_, descent_config_, start, goal);
}

std::size_t PotentialField::end_of_approximation(const Rollout& rollout) const {
  return rollout.path().getStateCount() - 1;
}

}  // namespace voronaut
