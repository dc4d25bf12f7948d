#pragma once

#include <memory>
#include <optional>

#include <ompl/base/Planner.h>

#include "voronaut/benchmarks/episode/episode_log.h"
#include "voronaut/benchmarks/trial/trial.h"
#include "voronaut/dynamics/model.h"
#include "voronaut/dynamics/regulator.h"
#include "voronaut/environments/random.h"
#include "voronaut/planners/mapping/free_space/free_space.h"
#include "voronaut/planners/mapping/virtual_obstacles.h"
#include "voronaut/planners/navigation/gaze.h"
#include "voronaut/planners/navigation/look_around.h"
#include "voronaut/planners/navigation/path_tracker.h"
#include "voronaut/planners/navigation/plan_request.h"
#include "voronaut/planners/navigation/recovery.h"
#include "voronaut/planners/navigation/replan_policy.h"
#include "voronaut/planners/navigation/safety_governor.h"
#include "voronaut/planners/navigation/speed_rule.h"
#include "voronaut/planners/navigation/way_flown.h"

namespace voronaut {

// The parts of one flight, wired to each other and to the truth. Each is usable alone; this is only
// where they meet.
struct Flight {
  Flight(const TrialSpec& spec, const PlannerCatalog& planners, bool keep_scans);

  // The stages of the loop, in the order of the data.
  void sense(const VehicleState& state, double now_s);
  void update_map();
  void plan(const VehicleState& state, double now_s);
  Setpoint navigate(const VehicleState& state, double now_s);
  void record_scan(const Setpoint& setpoint);

  bool scan_is_due(std::size_t tick) const { return tick % ticks_per_scan == 0; }

  // Parts of plan() and navigate().
  bool depart(const VehicleState& state, double now_s);
  void recover(const VehicleState& state, double now_s);
  void adopt(Plan plan, double now_s);
  void judge_infeasible(double now_s);
  void retrace();
  void govern(const VehicleState& state, const Vec2& towards, bool squeezing, Setpoint& setpoint);
  std::optional<Vec2> crowding(const Vec2& p_world) const;
  std::optional<Vec2> hemming_in(const Vec2& p_world) const;
  std::optional<Vec2> in_doubt(const VehicleState& state) const;
  Vec2 leaning_away(const Vec2& towards, const Vec2& p_world) const;

  const TrialSpec& spec;
  const bool keep_scans;
  const std::size_t ticks_per_scan;

  std::unique_ptr<Model> model;
  std::unique_ptr<Regulator> regulator;
  RangeFinder range_finder;
  Random sensor_noise;
  Scan scan;
  ObstacleBase map;
  FreeSpace free_space;                // kept up to date for the governor only
  VirtualObstacles virtual_obstacles;  // what planners see beside the map
  Belief belief;
  PlanningProblem problem;
  PlannerTraits planner_traits;
  ompl::base::PlannerPtr planner;
  ReplanPolicy replan_policy;
  PathTracker tracker;
  GazePolicy gaze;
  LookAround look_around;
  RecoveryPolicy recovery;
  Braking braking;
  std::optional<SafetyGovernor> governor;
  Referee referee;
  ExecutiveState executive = ExecutiveState::rising;
  bool departed = false;
  double back_off_until_s = 0;
  std::optional<Vec2> back_off_from;
  double squeeze_until_s = 0;
  WayFlown way_flown;
  bool retracing = false;
  std::optional<Vec2> refused_at;  // by the governor, at the latest scan
  Setpoint held;                   // a governed setpoint lasts until the next scan
  EpisodeLog log;
};

// Flies from the start until the referee has a verdict.
EpisodeLog fly(Flight& flight);

}  // namespace voronaut
