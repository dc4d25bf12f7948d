#pragma once

#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "voronaut/dynamics/footprint.h"
#include "voronaut/dynamics/limits.h"
#include "voronaut/dynamics/motion_response.h"
#include "voronaut/dynamics/speed_profile.h"
#include "voronaut/environments/shapes/geometry.h"
#include "voronaut/planners/mapping/obstacle_base.h"
#include "voronaut/planners/navigation/declared_errors.h"
#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/problem/planning_budget.h"

// Everything that a navigator is told before it starts. SI units, world frame W.
namespace voronaut {

// From where to where, and within what.
struct Mission {
  Vec2 start_world = Vec2::Zero();
  Vec2 start_heading = Vec2::UnitX();  // unit vector
  Vec2 goal_world = Vec2::Zero();
  double goal_tolerance_m = 0.2;
  double cruise_height_m = 1;  // of the centre of mass; 0 for what rolls on the ground
  // Where the vehicle's centre may be: for planners and governor alike. Memory for known-free space
  // grows with their area.
  Bounds bounds_world{Vec2(-10, -10), Vec2(10, 10)};
};

// A vehicle that flies rises before it sets off, or it would leave the ground slanting. It has its
// height when it is this close and this slow: what is left then is gone before the first corner.
inline constexpr double kHeightReached_m = 0.05;
inline constexpr double kHeightReached_m_s = 0.1;

// Where a vehicle can go from where it stands.
enum class Steering {
  any_direction,  // moves sideways as well as ahead
  along_heading,  // wheels: turns before it drives
};

// What navigation must know of a vehicle under its regulator.
struct VehicleFacts {
  double body_radius_m = 0.25;  // upright cylinder about the centre of mass that holds the body
  Footprint footprint = {};     // what of it the body is; without corners all of it
  double planning_clearance_m = 0.40;  // planning: centre of mass to obstacle
  Steering steering = Steering::any_direction;
  MotionLimits limits;
  // How it stops: the gain of its velocity loop and its largest deceleration (dynamics/stopping.h).
  double velocity_gain_1_s = 1.786;
  double deceleration_m_s2 = 3;
  // How it slows down towards the goal.
  SpeedProfileConfig goal_profile;
  // How its motion answers a command: velocities where it moves in any direction, arcs where it
  // drives along its heading. The safety governor needs it and nothing else does.
  std::optional<MotionResponse> motion_response;

  // Planned as a disc that does not hold it.
  bool planned_smaller() const {
    return footprint.planned_radius_m > 0 && footprint.planned_radius_m < body_radius_m;
  }
};

struct RangeFinderFacts {
  double field_of_view_rad = std::numbers::pi / 2;  // centred on the heading
  double period_s = 0.05;                           // from one scan to the next
};

struct NavigatorConfig {
  Mission mission;
  VehicleFacts vehicle;
  RangeFinderFacts range_finder;
  std::string planner;                                // in the catalogue
  std::map<std::string, std::string> planner_params;  // by the planner's own names
  PlanningBudget budget;
  ObstacleBaseConfig mapping;
  NavigationConfig navigation;
  DeclaredErrors errors;  // of pose and latency: what StateEstimate makes of them
};

}  // namespace voronaut
