#include "voronaut/planners/voronoi/voronoi_roadmap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/config.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/catalog/parameter_declaration.h"
#include "voronaut/planners/problem/planar_state.h"

namespace voronaut {

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace {

// OMPL's goal regions are open: a place at the very threshold does not satisfy them.
constexpr double kInsideThreshold = 0.999;
constexpr double kLeastTolerance_m = 1e-6;

constexpr const char* kGoalBlocked = "no place within the goal's tolerance has the clearance";
constexpr const char* kRefused = "the motion validator refuses the route found";

}  // namespace

VoronoiRoadmap::VoronoiRoadmap(const ob::SpaceInformationPtr& si)
    : Planner(si, "VoronoiRoadmap"), best_cost_(std::numeric_limits<double>::infinity()) {
  specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
  ParameterDeclaration declaration(params_);
  config_.visit(declaration);
  addPlannerProgressProperty("roadmap vertices INTEGER",
                             [this] { return std::to_string(vertex_count_); });
  addPlannerProgressProperty("roadmap edges INTEGER",
                             [this] { return std::to_string(edge_count_); });
  addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(best_cost_); });
}

VoronoiRoadmap::~VoronoiRoadmap() { forget_query(); }

void VoronoiRoadmap::setup() {
  Planner::setup();
  if (!has_position(*si_->getStateSpace()))
    throw ompl::Exception(getName(), "needs a state space with a position in the plane");
  specs_.provingSolutionNonExistence = geometry() != nullptr;
}

void VoronoiRoadmap::clear() {
  Planner::clear();
  forget_query();
}

void VoronoiRoadmap::clearQuery() { clear(); }

void VoronoiRoadmap::forget_query() {
  free_states(starts_);
  free_states(goals_);
  free_states(data_states_);
  solution_.clear();
  proved_no_path_ = false;
  failure_reason_ = {};
  vertex_count_ = 0;
  edge_count_ = 0;
  best_cost_ = std::numeric_limits<double>::infinity();
}

void VoronoiRoadmap::free_states(std::vector<ob::State*>& states) const {
  si_->freeStates(states);
  states.clear();
}

const KnownGeometry* VoronoiRoadmap::geometry() const {
  return dynamic_cast<const KnownGeometry*>(si_->getStateValidityChecker().get());
}

ob::PlannerStatus VoronoiRoadmap::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  const auto* goal = dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (!goal) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
  const KnownGeometry* known = geometry();
  specs_.provingSolutionNonExistence = known != nullptr;
  // Starts and goals are read anew: whatever was added since the last solve is among them.
  forget_query();
  pis_.restart();
  read_starts();
  if (starts_.empty()) return ob::PlannerStatus::INVALID_START;
  const bool all_goals = read_goals(*goal, ptc, known != nullptr);
  if (ptc()) return failure(kTimeout, false, ob::PlannerStatus::TIMEOUT);
  if (goals_.empty()) return failure("no goal is valid", false, ob::PlannerStatus::INVALID_GOAL);
  return known ? solve_exactly(*known, all_goals, ptc) : solve_by_sampling(ptc);
}

void VoronoiRoadmap::read_starts() {
  while (const ob::State* start = pis_.nextStart()) starts_.push_back(si_->cloneState(start));
}

bool VoronoiRoadmap::read_goals(const ob::GoalSampleableRegion& goal,
                                const ob::PlannerTerminationCondition& ptc, bool exact) {
  const auto limit = static_cast<std::size_t>(config_.goals_max);
  const bool listed = dynamic_cast<const ob::GoalState*>(&goal) != nullptr ||
                      dynamic_cast<const ob::GoalStates*>(&goal) != nullptr;
  // OMPL waits for goals to come, until the termination condition is met, even where all are known.
  const ob::State* first = listed ? pis_.nextGoal() : pis_.nextGoal(ptc);
  while (listed && !first && pis_.haveMoreGoalStates()) first = pis_.nextGoal();
  if (first) goals_.push_back(si_->cloneState(first));
  while (!goals_.empty() && goals_.size() < limit && pis_.haveMoreGoalStates() && !ptc()) {
    const ob::State* more = pis_.nextGoal();
    if (!more) break;
    goals_.push_back(si_->cloneState(more));
  }
  const auto* single = dynamic_cast<const ob::GoalState*>(&goal);
  // A goal state that is not valid still stands for the places around it.
  if (exact && goals_.empty() && single && si_->satisfiesBounds(single->getState()))
    goals_.push_back(si_->cloneState(single->getState()));
  return single || (dynamic_cast<const ob::GoalStates*>(&goal) && !pis_.haveMoreGoalStates());
}

double VoronoiRoadmap::tolerance_m() const {
  const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
  const double tolerance = goal ? kInsideThreshold * goal->getThreshold() : 0;
  return tolerance < kLeastTolerance_m ? 0 : tolerance;
}

ob::PlannerStatus VoronoiRoadmap::solve_exactly(const KnownGeometry& known, bool all_goals,
                                                const ob::PlannerTerminationCondition& ptc) {
  const MotionCheck motion_is_clear = [&known](const Vec2& a, const Vec2& b) {
    return known.motion_is_clear(a, b);
  };
  const Bounds bounds = position_bounds(*si_->getStateSpace());
  router_.observe(known.known_obstacles().points(), bounds, known.planning_clearance_m(),
                  starts_and_goals());

  Question answered{nullptr, nullptr, tolerance_m()};
  Route best;
  bool proved = all_goals;
  std::string_view why;
  for (const ob::State* start : starts_) {
    for (const ob::State* goal : goals_) {
      if (ptc()) return failure(kTimeout, false, ob::PlannerStatus::TIMEOUT);
      const Question question{start, goal, answered.tolerance_m};
      Route route = ask_twice(question, bounds, motion_is_clear);
      if (!is_valid_path(start, route.points)) {
        proved = false;
        why = kRefused;
      } else if (route.verdict != Route::Verdict::found) {
        proved = proved && route.proved_no_path();
        why = reason(route.verdict);
      } else if (best.points.empty() || route.length_m < best.length_m) {
        best = std::move(route);
        answered = question;
      }
    }
  }
  if (!best.points.empty()) return report(answered, best);
  if (any_valid_goal()) return failure(why, proved, ob::PlannerStatus::TIMEOUT);
  return failure(kGoalBlocked, proved, ob::PlannerStatus::INVALID_GOAL);
}

std::vector<Vec2> VoronoiRoadmap::starts_and_goals() const {
  std::vector<Vec2> places;
  for (const ob::State* start : starts_) places.push_back(position(start));
  for (const ob::State* goal : goals_) places.push_back(position(goal));
  return places;
}

bool VoronoiRoadmap::any_valid_goal() const {
  return std::any_of(goals_.begin(), goals_.end(),
                     [this](const ob::State* g) { return si_->isValid(g); });
}

// The validator has the last word: it may know more than the geometry says.
Route VoronoiRoadmap::ask_twice(const Question& question, const Bounds& bounds,
                                const MotionCheck& motion_is_clear) {
  Route route = ask(question, bounds, motion_is_clear, config_.shortening);
  if (is_valid_path(question.start, route.points)) return route;
  return ask(question, bounds, motion_is_clear, Shortening::none);
}

Route VoronoiRoadmap::ask(const Question& question, const Bounds& bounds,
                          const MotionCheck& motion_is_clear, Shortening shortening) {
  RouteQuery query;
  query.start = clamped(position(question.start), bounds);
  query.goal = clamped(position(question.goal), bounds);
  query.shortening = shortening;
  query.motion_is_clear = motion_is_clear;
  return router_.route_near(query, question.tolerance_m);
}

ob::PlannerStatus VoronoiRoadmap::failure(std::string_view why, bool proved,
                                          ob::PlannerStatus::StatusType otherwise) {
  failure_reason_ = why;
  proved_no_path_ = proved;
#if OMPL_VERSION_VALUE >= 1006000
  if (proved) return ob::PlannerStatus::INFEASIBLE;
#endif
  return otherwise;
}

ob::PlannerStatus VoronoiRoadmap::report(const Question& question, const Route& route) {
  const auto path = std::make_shared<og::PathGeometric>(si_);
  const ob::StateSpace& space = *si_->getStateSpace();
  ob::State* state = si_->cloneState(question.start);
  path->append(state);
  for (std::size_t i = 1; i + 1 < route.points.size(); ++i) {
    set_position(space, state, route.points[i]);
    path->append(state);
  }
  si_->copyState(state, question.goal);
  if (position(question.goal) != route.points.back())
    set_position(space, state, route.points.back());
  path->append(state);
  si_->freeState(state);

  solution_ = route.points;
  best_cost_ = route.length_m;
  vertex_count_ = router_.graph().vertices().size();
  edge_count_ = router_.graph().edges().size();
  pdef_->addSolutionPath(path, false, 0, getName());
  return ob::PlannerStatus::EXACT_SOLUTION;
}

Vec2 VoronoiRoadmap::position(const ob::State* state) const {
  return position_of(*si_->getStateSpace(), state);
}

bool VoronoiRoadmap::is_valid_motion(const ob::State* like, const Vec2& a, const Vec2& b) const {
  return is_valid_path(like, {a, b});
}

bool VoronoiRoadmap::is_valid_path(const ob::State* like, const std::vector<Vec2>& path) const {
  const ob::StateSpace& space = *si_->getStateSpace();
  ob::State* from = si_->cloneState(like);
  ob::State* to = si_->cloneState(like);
  bool valid = true;
  for (std::size_t i = 1; valid && i < path.size(); ++i) {
    set_position(space, from, path[i - 1]);
    set_position(space, to, path[i]);
    valid = si_->checkMotion(from, to);
  }
  si_->freeState(from);
  si_->freeState(to);
  return valid;
}

namespace {

unsigned add_on_path(ob::PlannerData& data, const ob::PlannerDataVertex& v, std::size_t i,
                     std::size_t n) {
  if (i == 0) return data.addStartVertex(v);
  return i + 1 == n ? data.addGoalVertex(v) : data.addVertex(v);
}

}  // namespace

void VoronoiRoadmap::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  if (starts_.empty() || router_.delaunay().site_count() == 0) return;
  const ob::StateSpace& space = *si_->getStateSpace();
  const auto state_at = [&](const Vec2& p) {
    ob::State* state = si_->cloneState(starts_.front());
    set_position(space, state, p);
    data_states_.push_back(state);
    return state;
  };
  const VoronoiGraph& graph = router_.graph();
  // Behind a sampled border the diagram goes on: what lies there is no part of the roadmap.
  constexpr unsigned kBehindBorder = std::numeric_limits<unsigned>::max();
  std::vector<unsigned> vertex;
  for (const Vec2& p : graph.vertices()) {
    const ob::State* state = state_at(p);
    vertex.push_back(si_->isValid(state) ? data.addVertex(ob::PlannerDataVertex(state))
                                         : kBehindBorder);
  }
  const auto connect = [&](unsigned a, unsigned b, double length_m) {
    data.addEdge(a, b, ob::PlannerDataEdge(), ob::Cost(length_m));
    data.addEdge(b, a, ob::PlannerDataEdge(), ob::Cost(length_m));
  };
  for (const VoronoiGraph::Edge& edge : graph.edges()) {
    if (vertex[edge.u] != kBehindBorder && vertex[edge.v] != kBehindBorder)
      connect(vertex[edge.u], vertex[edge.v], edge.length_m);
  }

  constexpr int kSolutionTag = 1;
  unsigned previous = 0;
  for (std::size_t i = 0; i < solution_.size(); ++i) {
    const ob::PlannerDataVertex v(state_at(solution_[i]), kSolutionTag);
    const unsigned index = add_on_path(data, v, i, solution_.size());
    if (i > 0) connect(previous, index, (solution_[i] - solution_[i - 1]).norm());
    previous = index;
  }
}

}  // namespace voronaut
