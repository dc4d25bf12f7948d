#include "voronaut/planners/problem/problem.h"

#include <ompl/base/spaces/RealVectorStateProjections.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include "voronaut/planners/problem/belief_validity_checker.h"
#include "voronaut/planners/problem/goal_placement.h"
#include "voronaut/planners/problem/planar_state.h"
#include "voronaut/planners/problem/search_graph.h"
#include "voronaut/planners/problem/swept_disc_motion_validator.h"

namespace voronaut {

namespace ob = ompl::base;

namespace {

// Motions are checked exactly; this is the spacing of states that planners interpolate.
constexpr double kInterpolationSpacing_m = 0.05;
// Cells per side of the grid on which projecting planners (KPIECE, SBL, ...) measure coverage:
// what OMPL takes by default.
constexpr double kProjectionCells = 20;

std::shared_ptr<ob::RealVectorStateSpace> plane(const Bounds& bounds_world) {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  for (unsigned axis = 0; axis < 2; ++axis) {
    bounds.setLow(axis, bounds_world.min[axis]);
    bounds.setHigh(axis, bounds_world.max[axis]);
  }
  space->setBounds(bounds);
  // OMPL 1.5.2's own default projection of a space of two dimensions reads out of bounds. Cell
  // sizes set by hand, or setup() puts that one back.
  const Vec2 cell = (bounds_world.max - bounds_world.min) / kProjectionCells;
  auto projection = std::make_shared<ob::RealVectorOrthogonalProjectionEvaluator>(
      space.get(), std::vector<double>{cell.x(), cell.y()}, std::vector<unsigned>{0, 1});
  space->registerDefaultProjection(projection);
  return space;
}

}  // namespace

PlanningProblem::PlanningProblem(const ProblemConfig& config) : config_(config) {
  const auto space = plane(config.bounds_world);
  si_ = std::make_shared<ob::SpaceInformation>(space);
  checker_ = std::make_shared<BeliefValidityChecker>(si_, config.planning_clearance_m);
  si_->setStateValidityChecker(checker_);
  si_->setMotionValidator(std::make_shared<SweptDiscMotionValidator>(si_, *checker_));
  si_->setStateValidityCheckingResolution(kInterpolationSpacing_m / space->getMaximumExtent());
  si_->setup();

  definition_ = std::make_shared<ob::ProblemDefinition>(si_);
  goal_ = std::make_shared<ob::GoalState>(si_);
  pose_goal(config.goal_world);
}

PlanningProblem::~PlanningProblem() = default;

void PlanningProblem::update(const Belief& belief, const Vec2& start_world) {
  checker_->look_at(belief, start_world);
  pose_problem(start_world);
}

void PlanningProblem::update(const ObstacleSnapshot& obstacles, const Vec2& start_world) {
  checker_->look_at(obstacles, start_world);
  pose_problem(start_world);
}

void PlanningProblem::keep(double planning_clearance_m) {
  config_.planning_clearance_m = planning_clearance_m;
  checker_->keep(planning_clearance_m);
}

void PlanningProblem::pose_problem(const Vec2& start_world) {
  definition_->clearSolutionPaths();
  definition_->clearStartStates();
  ob::ScopedState<> start(si_);
  set_position(*si_->getStateSpace(), start.get(), start_world);
  definition_->addStartState(start);

  const auto place =
      place_for_goal(config_.goal_world, config_.goal_tolerance_m, config_.bounds_world,
                     checker_->known_obstacles(), config_.planning_clearance_m);
  goal_has_place_ = place.has_value();
  pose_goal(place.value_or(config_.goal_world));
  request_ = {start_world, config_.goal_world, place.value_or(config_.goal_world),
              config_.goal_tolerance_m, config_.bounds_world};
}

// Anew for each solve, as the planner of the last one had it in its hands.
void PlanningProblem::pose_goal(const Vec2& place_world) {
  ob::ScopedState<> goal(si_);
  set_position(*si_->getStateSpace(), goal.get(), place_world);
  goal_->setState(goal);
  goal_->setThreshold(config_.goal_tolerance_m);
  definition_->setGoal(goal_);
}

BudgetMeter PlanningProblem::meter(const PlanningBudget& budget) const {
  return {budget, [checker = checker_] { return checker->checks(); }};
}

const KnownGeometry& PlanningProblem::geometry() const { return *checker_; }

std::vector<Segment> PlanningProblem::searched_edges(const ob::Planner& planner) const {
  const std::uint64_t counted = checker_->checks();
  std::vector<Segment> edges = search_graph(planner, *si_->getStateSpace());
  checker_->count_again_from(counted);
  return edges;
}

std::uint64_t PlanningProblem::state_checks() const { return checker_->checks(); }

}  // namespace voronaut
