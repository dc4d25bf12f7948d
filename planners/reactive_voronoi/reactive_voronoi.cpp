#include "voronaut/planners/reactive_voronoi/reactive_voronoi.h"

#include <algorithm>
#include <stdexcept>

#include <ompl/util/Exception.h>

#include "voronaut/planners/parameter_declaration.h"
#include "voronaut/planners/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// A goal region may offer goals without end.
constexpr std::size_t kMostGoals = 4;

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
    : Planner(si, "ReactiveVoronoi") {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  specs_.approximateSolutions = true;
  specs_.directed = true;
  ParameterDeclaration declaration(params_);
  config_.visit(declaration);
  mission_config_.visit(declaration);
  params_.declareParam<std::string>(
      "preset", [this](const std::string& name) { set_preset(name); }, [this] { return preset(); });
  params_["preset"].setRangeSuggestion("as_published,repaired");
}

ReactiveVoronoi::~ReactiveVoronoi() { free_states(); }

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

void ReactiveVoronoi::setup() {
  Planner::setup();
  if (!has_position(*si_->getStateSpace()))
    throw ompl::Exception(getName(),
                          "plans in the plane: RealVectorStateSpace(2) or SE2StateSpace");
}

void ReactiveVoronoi::clear() {
  Planner::clear();
  free_states();
  attempts_.clear();
  leg_.reset();
  memory_ = {};
  mode_ = ReactiveMode::none;
}

void ReactiveVoronoi::free_states() {
  for (ob::State* state : starts_) si_->freeState(state);
  for (ob::State* state : goals_) si_->freeState(state);
  starts_.clear();
  goals_.clear();
}

ob::PlannerStatus ReactiveVoronoi::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  auto* goal = dynamic_cast<ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (!goal) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  const auto* geometry = dynamic_cast<const KnownGeometry*>(si_->getStateValidityChecker().get());
  if (geometry && geometry->belief()) return next_leg(*geometry, *goal);
  return fly_missions(ptc);
}

ob::PlannerStatus ReactiveVoronoi::next_leg(const KnownGeometry& geometry,
                                            ob::GoalSampleableRegion& goal) {
  pis_.restart();  // the start is another one in every solve
  const ob::State* start = pis_.nextStart();
  if (!start) return ob::PlannerStatus::INVALID_START;
  const ob::StateSpace& space = *si_->getStateSpace();
  ob::ScopedState<> target(si_);
  goal.sampleGoal(target.get());
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

ob::PlannerStatus ReactiveVoronoi::fly_missions(const ob::PlannerTerminationCondition& ptc) {
  while (const ob::State* start = pis_.nextStart()) starts_.push_back(si_->cloneState(start));
  if (starts_.empty()) return ob::PlannerStatus::INVALID_START;
  if (!read_goals(ptc)) return ob::PlannerStatus::INVALID_GOAL;

  do {
    if (attempts_.empty() || attempts_.back().mission.status() == Mission::Status::stuck)
      if (!begin_attempt()) break;
    Mission& mission = attempts_.back().mission;
    while (mission.status() == Mission::Status::under_way && !ptc) mission.advance();
    mode_ = mission.mode();
  } while (attempts_.back().mission.status() != Mission::Status::at_goal && !ptc);

  const auto best =
      std::min_element(attempts_.begin(), attempts_.end(), [](const Attempt& a, const Attempt& b) {
        return a.mission.closest_m() < b.mission.closest_m();
      });
  return report(*best);
}

bool ReactiveVoronoi::read_goals(const ob::PlannerTerminationCondition& ptc) {
  if (goals_.empty()) {
    if (const ob::State* goal = pis_.nextGoal(ptc)) goals_.push_back(si_->cloneState(goal));
  }
  while (goals_.size() < kMostGoals && pis_.haveMoreGoalStates()) {
    const ob::State* goal = pis_.nextGoal();
    if (!goal) break;
    goals_.push_back(si_->cloneState(goal));
  }
  return !goals_.empty();
}

// The first pair of a start and a goal that has not been tried, in the order in which they came.
bool ReactiveVoronoi::begin_attempt() {
  for (std::size_t start = 0; start < starts_.size(); ++start) {
    for (std::size_t goal = 0; goal < goals_.size(); ++goal) {
      const bool tried = std::any_of(attempts_.begin(), attempts_.end(), [&](const Attempt& each) {
        return each.start == start && each.goal == goal;
      });
      if (tried) continue;
      attempts_.push_back(
          {start, goal, Mission(si_, config_, mission_config_, starts_[start], goals_[goal])});
      return true;
    }
  }
  return false;
}

ob::PlannerStatus ReactiveVoronoi::report(const Attempt& attempt) {
  const Mission& mission = attempt.mission;
  const bool exact = mission.status() == Mission::Status::at_goal;
  if (!exact && mission.closest_index() == 0) return ob::PlannerStatus::TIMEOUT;
  auto path = std::make_shared<og::PathGeometric>(si_);
  for (std::size_t i = 0; i <= mission.closest_index(); ++i)
    path->append(mission.executed().getState(static_cast<unsigned>(i)));
  pdef_->addSolutionPath(path, !exact, mission.closest_m(), getName());
  return {true, !exact};
}

void ReactiveVoronoi::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  const auto add_chain = [&](const og::PathGeometric& path) {
    const unsigned count = static_cast<unsigned>(path.getStateCount());
    for (unsigned i = 0; i < count; ++i) {
      const ob::PlannerDataVertex vertex(path.getState(i));
      if (i == 0)
        data.addStartVertex(vertex);
      else
        data.addEdge(ob::PlannerDataVertex(path.getState(i - 1)), vertex);
    }
  };
  for (const Attempt& attempt : attempts_) {
    const og::PathGeometric& way = attempt.mission.executed();
    add_chain(way);
    if (attempt.mission.status() == Mission::Status::at_goal)
      data.markGoalState(way.getState(static_cast<unsigned>(way.getStateCount() - 1)));
  }
  if (leg_) add_chain(*leg_);
}

}  // namespace voronaut
