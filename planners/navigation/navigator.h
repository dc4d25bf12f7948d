#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <ompl/base/Planner.h>

#include "voronaut/planners/catalog/catalog.h"
#include "voronaut/planners/mapping/free_space/doubted_scan.h"
#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/mapping/virtual_obstacles.h"
#include "voronaut/planners/navigation/breadcrumb_trail.h"
#include "voronaut/planners/navigation/look_around.h"
#include "voronaut/planners/navigation/navigation_report.h"
#include "voronaut/planners/navigation/navigator_config.h"
#include "voronaut/planners/navigation/path_tracker.h"
#include "voronaut/planners/navigation/plan_request.h"
#include "voronaut/planners/navigation/recovery.h"
#include "voronaut/planners/navigation/replan_policy.h"
#include "voronaut/planners/navigation/safety_governor.h"
#include "voronaut/planners/navigation/speed_rule.h"
#include "voronaut/planners/navigation/yaw_policy.h"

namespace voronaut {

// What a robot runs: scans and poses in, setpoints out. It keeps a map, asks a planner for paths
// over it, follows them, and decides what to do when the vehicle does not get on. It knows nothing
// of the true world. docs/embedding.md tells how to put it into a robot.
//
//   Navigator navigator(config, PlannerCatalog::built_in());
//   on every scan:  setpoint = navigator.update(scan, state, now_s);
//   in between:     setpoint = navigator.steer(state, now_s);      // once per regulator step
//
// Times are seconds since the mission began and never go back. The same calls give the same
// setpoints, bit for bit, where the planner is reproducible. Not thread-safe.
class Navigator {
 public:
  // Throws std::invalid_argument if the catalogue does not have the planner, the planner refuses a
  // parameter, or a governor is asked for a vehicle that has no motion response or one of the other
  // kind.
  Navigator(const NavigatorConfig& config, const PlannerCatalog& planners);
  Navigator(const Navigator&) = delete;  // the problem points into it
  Navigator& operator=(const Navigator&) = delete;

  // A scan and the state in which it was taken: maps it, plans if there is a reason to, and says
  // what to do. Time: what the planner's budget allows, beside it O(beams). Passes on what the
  // planner throws.
  Setpoint update(const Scan& scan, const VehicleState& state, double now_s);
  // What to do between two scans. A governed setpoint lasts until the next scan. O(path) at most.
  Setpoint steer(const VehicleState& state, double now_s);

  // The first two stages of update(); steer() is the third.
  void map(const Scan& scan);
  void plan(const VehicleState& state, double now_s);

  const NavigationReport& report() const { return report_; }
  // Null: nobody. Must outlive the navigator or be taken off.
  void observe(NavigationObserver* observer) { observer_ = observer; }

  const Scan& scan() const { return scan_; }                  // the latest
  const Path& path() const { return tracker_.path(); }        // being followed; empty: none
  ObstacleSnapshot known() const { return map_.snapshot(); }  // valid until the next scan
  const PlannerTraits& planner_traits() const { return planner_traits_; }
  std::uint64_t state_checks() const { return problem_.state_checks(); }  // by all solves so far
  // What the planner's latest solve looked at (planners/problem/search_graph.h).
  std::vector<Segment> searched_edges() const { return problem_.searched_edges(*planner_); }

 private:
  // planning: navigator.cpp
  bool depart(const VehicleState& state, double now_s);
  void follow_trail(const Vec2& p_world);
  Plan ask_from(const Vec2& start_world);
  void adopt(Plan plan);
  void judge_infeasible();
  void look_around(const VehicleState& state);
  Plan plan_that_fits();
  void retrace();
  void follow(Path path, PathEnd end);
  void note_arrival(const VehicleState& state);

  // recovery: navigator_recovery.cpp
  void recover(const VehicleState& state, double now_s);
  void act(RecoveryAction action, const VehicleState& state, double now_s);
  std::optional<Vec2> nearest_obstacle_within_clearance(const Vec2& p_world) const;
  std::optional<Vec2> nearest_unknown_within_clearance(const Vec2& p_world) const;
  std::optional<Vec2> nearest_within_clearance(const Vec2& p_world) const;
  std::optional<Vec2> unknown_that_holds_back(const VehicleState& state) const;
  std::optional<Vec2> unknown_to_look_at(const VehicleState& state);
  double clearance_of_corners_m() const;
  bool is_on_surface(const Vec2& unknown_world) const;

  // steering: navigator_steering.cpp
  LookaheadPoint lookahead(const VehicleState& state, double now_s, Setpoint& setpoint);
  double lookahead_clearance_m(const Vec2& p_world) const;
  bool governs_wheels() const;
  bool sweeps_by_turning() const { return governor_ && governor_->sweeps_by_turning(); }
  bool governs_turning_wheels() const;
  double kept_from_known_m() const;
  void leave_what_it_touches(WantedMotion& wanted, const VehicleState& state, KnownClearance kept);
  Vec2 repulsive_heading(const Vec2& towards, const Vec2& p_world) const;
  Vec2 kept_within_bounds(const Vec2& towards, const VehicleState& state) const;
  MotionCommand govern(const WantedMotion& wanted, const VehicleState& state, KnownClearance kept);

  const NavigatorConfig config_;
  Scan scan_;
  ObstacleBase map_;
  FreeSpace free_space_;  // kept up to date for the governor only
  DoubtedScan doubted_;
  VirtualObstacles virtual_obstacles_;  // what planners see beside the map
  Belief belief_;
  PlanningProblem problem_;
  PlannerTraits planner_traits_;
  ompl::base::PlannerPtr planner_;
  ReplanPolicy replan_policy_;
  PathTracker tracker_;
  YawPolicy yaw_policy_;
  LookAround look_around_;
  RecoveryPolicy recovery_;
  Braking braking_;
  std::optional<SafetyGovernor> governor_;
  BreadcrumbTrail trail_;

  bool scan_is_new_ = false;
  bool arrived_ = false;  // has been within the goal's tolerance
  bool retracing_ = false;
  double back_off_until_s_ = 0;
  std::optional<Vec2> back_off_from_;
  double reduced_clearance_until_s_ = 0;
  std::optional<Vec2> refused_at_;       // by the governor, at the latest scan
  Vec2 paces_at_ = Vec2::Constant(1e9);  // it has not got away from there since
  double paces_since_s_ = 0;
  std::optional<Vec2> looks_at_;  // on wheels: an unknown place that it turns to
  bool asks_for_fit_ = false;     // of paths: holds the footprint against known points along them
  Vec2 left_along_ = Vec2::UnitX();  // where it left last; a polygon goes on that way
  bool leaves_ = false;              // on wheels: what its tube touches as it stands
  NavigationReport report_;
  NavigationObserver* observer_ = nullptr;
};

}  // namespace voronaut
