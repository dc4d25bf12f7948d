#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>

#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/problem/belief.h"
#include "voronaut/planners/problem/known_geometry.h"
#include "voronaut/planners/problem/path_request.h"
#include "voronaut/planners/problem/planning_budget.h"

// A planning problem over what is known: known obstacles (unknown counts as free), a start, a goal,
// bounds and a clearance, as OMPL sees it.
namespace voronaut {

struct ProblemConfig {
  Bounds bounds_world;
  Vec2 goal_world = Vec2::Zero();
  double goal_tolerance_m = 0.2;
  double planning_clearance_m = 0.4;  // centre of the vehicle to the closest known point
};

class BeliefValidityChecker;

// Lives as long as an episode: OMPL binds a planner to its space information for life. The checkers
// hold a pointer to the current belief, which is swapped between solves, never during one.
class PlanningProblem {
 public:
  explicit PlanningProblem(const ProblemConfig& config);
  ~PlanningProblem();

  const ompl::base::SpaceInformationPtr& space_information() const { return si_; }
  const ompl::base::ProblemDefinitionPtr& definition() const { return definition_; }

  // Look at this belief from now on; it must stay alive until the next call. A start closer than
  // planning_clearance_m to a known point relaxes the clearance inside the disc around it, for
  // every planner alike; solutions of an earlier solve are dropped.
  void update(const Belief& belief, const Vec2& start_world);
  // The same for a static problem: nobody is under way, planners see the whole of it at once.
  void update(const ObstacleSnapshot& obstacles, const Vec2& start_world);

  // Another clearance, from the next update() on.
  void keep(double planning_clearance_m);

  // False if no place within the goal's tolerance keeps the clearance: a proof that there is no
  // path.
  bool goal_has_place() const { return goal_has_place_; }

  // What paths are judged by: nothing that a planner does to definition() changes it.
  const PathRequest& request() const { return request_; }

  // Counts a solve's work from now on. Valid as long as the problem lives.
  BudgetMeter meter(const PlanningBudget& budget) const;

  // What the checkers look at; for the executive, which asks the same exact questions.
  const KnownGeometry& geometry() const;

  std::uint64_t state_checks() const;  // states and motions checked so far, over all solves

  // What the planner's latest solve looked at (search_graph.h). What it checks while it tells is
  // not counted: pictures change no result.
  std::vector<Segment> searched_edges(const ompl::base::Planner& planner) const;

 private:
  void pose_problem(const Vec2& start_world);
  void pose_goal(const Vec2& place_world);

  ProblemConfig config_;
  PathRequest request_;
  ompl::base::SpaceInformationPtr si_;
  ompl::base::ProblemDefinitionPtr definition_;
  std::shared_ptr<ompl::base::GoalState> goal_;
  std::shared_ptr<BeliefValidityChecker> checker_;
  bool goal_has_place_ = true;
};

}  // namespace voronaut
