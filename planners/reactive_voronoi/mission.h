#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/reactive_voronoi/reactive_step.h"

// The papers' planner on a static problem: a mission in miniature. A vehicle that knows nothing
// senses, maps, decides and moves, and its way is the path.
namespace voronaut {

// Lengths are in the units of the state space, metres elsewhere.
struct MissionConfig {
  double sensing_range_m = 2.5;  // the papers' locator
  double sensing_field_of_view_rad =
      1.570796326794897;  // +-45 deg about the first line to the goal
  int sensing_rays = 91;
  double ray_resolution_m = 0.05;  // of rays marched through a plain validity checker
  double step_m = 0.1;             // travelled between two scans
  int stall_steps = 300;           // so many steps without coming closer to the goal: stuck

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("sensing_range_m", sensing_range_m, 1e-3, 1e4);
    v.number("sensing_field_of_view_rad", sensing_field_of_view_rad, 0.01, 6.283185307179586);
    v.count("sensing_rays", sensing_rays, 2, 100'000);
    v.number("ray_resolution_m", ray_resolution_m, 1e-5, 100);
    v.number("step_m", step_m, 1e-5, 100);
    v.count("stall_steps", stall_steps, 1, 1'000'000);
  }
};

// Distance from a point along a unit direction to the first thing a range finder would see, at most
// max_range_m. Nothing is seen beyond the bounds of the space.
using RayRange = std::function<double(const Vec2& from, const Vec2& direction, double max_range_m)>;

// Exact to a centimetre where the validity checker is a KnownGeometry (known points are seen as
// discs of 5 cm, so that a thinned surface has no holes); else marched through
// isValid() in steps of resolution_m, with the state's other components as in `reference`.
RayRange ray_range(const ompl::base::SpaceInformationPtr& si, const ompl::base::State* reference,
                   double resolution_m);

class Mission {
 public:
  enum class Status { under_way, at_goal, stuck };

  // From a valid start to a valid goal; both are copied.
  Mission(const ompl::base::SpaceInformationPtr& si, const ReactiveVoronoiConfig& planner,
          const MissionConfig& config, const ompl::base::State* start,
          const ompl::base::State* goal);

  // One cycle: sense, map, decide, move by step_m. Stuck: the next step is not a valid motion, or
  // no progress for stall_steps. No effect once the mission has ended.
  Status advance();

  Status status() const { return status_; }
  ReactiveMode mode() const { return mode_; }
  // The way so far; its last state is a copy of the goal if the mission ended there.
  const ompl::geometric::PathGeometric& executed() const { return *executed_; }
  // The state of that way closest to the goal, and how close it is.
  std::size_t closest_index() const { return closest_index_; }
  double closest_m() const { return closest_m_; }

 private:
  Vec2 decide();
  bool move_to(const Vec2& target);

  ompl::base::SpaceInformationPtr si_;
  ReactiveVoronoiConfig planner_;
  MissionConfig config_;
  RayRange ray_range_;
  ObstacleBase base_;
  ReactiveMemory memory_;
  Scan scan_;
  Vec2 goal_world_;
  std::shared_ptr<ompl::geometric::PathGeometric> executed_;
  std::shared_ptr<ompl::geometric::PathGeometric> goal_;  // one state
  Status status_ = Status::under_way;
  ReactiveMode mode_ = ReactiveMode::none;
  std::size_t closest_index_ = 0;
  double closest_m_ = 0;
  int steps_without_progress_ = 0;
};

}  // namespace voronaut
