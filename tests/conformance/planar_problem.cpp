#include "voronaut/tests/conformance/planar_problem.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateProjections.h>

#include "voronaut/planners/problem/planar_state.h"

namespace voronaut::test {

namespace ob = ompl::base;

namespace {

void place(ob::ScopedState<>& state, const Vec2& p) {
  state[0] = p.x();
  state[1] = p.y();
  if (state.getSpace()->getDimension() > 2) state[2] = 0;
}

std::shared_ptr<ob::StateSpace> make_space(Space kind, const std::shared_ptr<long>& alive) {
  if (kind == Space::se2) {
    auto space = std::make_shared<Counting<ob::SE2StateSpace>>(alive);
    ob::RealVectorBounds square(2);
    square.setLow(0);
    square.setHigh(10);
    space->setBounds(square);
    return space;
  }
  auto space = std::make_shared<Counting<ob::RealVectorStateSpace>>(alive, 2U);
  space->setBounds(0, 10);
  space->registerDefaultProjection(std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(
      space.get(), std::vector<double>{0.5, 0.5}, std::vector<unsigned>{0, 1}));
  return space;
}

}  // namespace

PlanarProblem::PlanarProblem(const IsFree& is_free, Space kind) {
  si = std::make_shared<ob::SpaceInformation>(make_space(kind, states_alive));
  si->setStateValidityChecker([is_free, si_ = si.get()](const ob::State* state) {
    return si_->satisfiesBounds(state) && is_free(planar(*si_, state));
  });
  si->setStateValidityCheckingResolution(0.002);
  si->setup();
}

ob::ProblemDefinitionPtr PlanarProblem::define(const std::vector<Vec2>& starts,
                                               const std::vector<Vec2>& goals) const {
  auto definition = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<> state(si);
  for (const Vec2& each : starts) {
    place(state, each);
    definition->addStartState(state);
  }
  auto goal = std::make_shared<ob::GoalStates>(si);
  for (const Vec2& each : goals) {
    place(state, each);
    goal->addState(state);
  }
  definition->setGoal(goal);
  // Any path satisfies: planners that optimise end with their first one, as in OMPL's own tests.
  const auto length = std::make_shared<ob::PathLengthOptimizationObjective>(si);
  length->setCostThreshold(length->infiniteCost());
  definition->setOptimizationObjective(length);
  return definition;
}

bool free_of_two_discs(const Vec2& p) {
  return (p - Vec2(5.3, 4.7)).norm() >= 0.6 && (p - Vec2(2, 7)).norm() >= 1;
}

PlanarProblem::IsFree with_ring_around(const Vec2& center) {
  return [center](const Vec2& p) {
    const double from_center = (p - center).norm();
    return free_of_two_discs(p) && (from_center < 0.4 || from_center > 0.7);
  };
}

Vec2 planar(const ob::SpaceInformation& si, const ob::State* state) {
  return position_of(*si.getStateSpace(), state);
}

}  // namespace voronaut::test
