#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"

#include <stdexcept>

#include <ompl/base/PlannerData.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/goals/GoalSampleableRegion.h>

#include "voronaut/planners/catalog/parameter_declaration.h"
#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

std::string canonical(const ReactiveVoronoiConfig& config) {
  ReactiveVoronoiConfig copy = config;
  ob::ParamSet fields;
  ParameterDeclaration declaration(fields);
  copy.visit(declaration);
  std::string text;
  for (const auto& [name, param] : fields.getParams()) text += param->getValue() + ";";
  return text;
}

}  // namespace

ReactiveVoronoi::ReactiveVoronoi(const ob::SpaceInformationPtr& si)
    : RolloutPlanner(si, "ReactiveVoronoi") {
  ParameterDeclaration declaration(params_);
  config_.visit(declaration);
  rollout_config_.visit(declaration);
  declaration.declare<std::string>(
      "preset", [this](const std::string& name) { set_preset(name); }, [this] { return preset(); },
      "as_published,repaired", "All choices of the papers, or all repairs, before single ones");
}

void ReactiveVoronoi::set_preset(const std::string& name) {
  if (name == "as_published")
    config_ = ReactiveVoronoiConfig::as_published();
  else if (name == "repaired")
    config_ = ReactiveVoronoiConfig::repaired();
  else
    throw std::invalid_argument("preset is 'as_published' or 'repaired', not '" + name + "'");
}

std::string ReactiveVoronoi::preset() const {
  const std::string fields = canonical(config_);
  if (fields == canonical(ReactiveVoronoiConfig::as_published())) return "as_published";
  if (fields == canonical(ReactiveVoronoiConfig::repaired())) return "repaired";
  return {};
}

void ReactiveVoronoi::clear() {
  RolloutPlanner::clear();
  leg_.reset();
  live_goal_.reset();
  live_goal_of_ = nullptr;
  memory_ = {};
  mode_ = ReactiveMode::none;
}

ob::PlannerStatus ReactiveVoronoi::solve(const ob::PlannerTerminationCondition& ptc) {
  const auto* geometry = dynamic_cast<const KnownGeometry*>(si_->getStateValidityChecker().get());
  if (geometry && geometry->belief()) return next_leg(*geometry);
  const ob::PlannerStatus status = RolloutPlanner::solve(ptc);
  if (const auto* rollout = static_cast<const ReactiveRollout*>(latest())) mode_ = rollout->mode();
  return status;
}

bool ReactiveVoronoi::choose_live_goal() {
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (goal && goal != live_goal_of_) {
    live_goal_ = std::make_shared<ob::ScopedState<>>(si_);
    goal->sampleGoal(live_goal_->get());
    live_goal_of_ = goal;
  }
  return goal != nullptr;
}

ob::PlannerStatus ReactiveVoronoi::next_leg(const KnownGeometry& geometry) {
  checkValidity();
  if (!choose_live_goal()) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  pis_.restart();  // the start is another one in every solve
  const ob::State* start = pis_.nextStart();
  if (!start) return ob::PlannerStatus::INVALID_START;
  const ob::StateSpace& space = *si_->getStateSpace();
  ob::ScopedState<> target(*live_goal_);
  const Vec2 goal_world = position_of(space, target.get());

  const ReactiveDecision decision = reactive_step(*geometry.belief(), goal_world, config_, memory_);
  mode_ = decision.mode;
  if (mode_ != ReactiveMode::none) {
    si_->copyState(target.get(), start);
    set_position(space, target.get(), clamped(decision.subgoal_world, position_bounds(space)));
  }
  const bool exact = mode_ == ReactiveMode::none && si_->checkMotion(start, target.get());
  leg_ = std::make_shared<og::PathGeometric>(si_, start, target.get());
  const double short_of_goal_m = (goal_world - position_of(space, target.get())).norm();
  pdef_->addSolutionPath(leg_, !exact, short_of_goal_m, getName());
  return {true, !exact};
}

std::unique_ptr<Rollout> ReactiveVoronoi::make_rollout(const ob::State* start,
                                                       const ob::State* goal) {
  return std::make_unique<ReactiveRollout>(si_, config_, rollout_config_, start, goal);
}

void ReactiveVoronoi::getPlannerData(ob::PlannerData& data) const {
  RolloutPlanner::getPlannerData(data);
  if (leg_) add_chain(*leg_, data);
}

}  // namespace voronaut
