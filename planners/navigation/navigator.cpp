#include "voronaut/planners/navigation/navigator.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "voronaut/planners/navigation/footprint_fit.h"
#include "voronaut/planners/navigation/governor_setup.h"
#include "voronaut/planners/navigation/shortcut.h"
#include "voronaut/planners/navigation/velocity_ladder.h"

// When to set off, when to plan, and what to make of the planner's answer.
namespace voronaut {

namespace {

ProblemConfig problem_config(const NavigatorConfig& config) {
  return {config.mission.bounds_world, config.mission.goal_world, config.mission.goal_tolerance_m,
          config.vehicle.planning_clearance_m};
}

const PlannerEntry& planner_entry(const NavigatorConfig& config, const PlannerCatalog& planners) {
  const PlannerEntry* entry = planners.find(config.planner);
  if (entry == nullptr) throw std::invalid_argument("unknown planner '" + config.planner + "'");
  return *entry;
}

ompl::base::PlannerPtr make_planner(const NavigatorConfig& config, const PlannerCatalog& planners,
                                    const PlanningProblem& problem) {
  ompl::base::PlannerPtr planner =
      planner_entry(config, planners).make(problem.space_information());
  set_parameters(*planner, config.planner, config.planner_params);
  return planner;
}

// Paths that a body does not fit along, at one scan; then the governor decides.
constexpr int kTriesToFit = 3;

// The velocity loop of a governed vehicle is faster than its regulator's; a goal is approached as
// much faster with the same damping.
SpeedProfileConfig goal_profile(const NavigatorConfig& config) {
  SpeedProfileConfig profile = config.vehicle.goal_profile;
  if (config.navigation.governor && config.vehicle.steering == Steering::any_direction)
    profile.goal_gain_1_s *= VelocityLadder::kVelocityGain;
  return profile;
}

// Where the body stands at the start is free.
void mark_start(const NavigatorConfig& config, FreeSpace& free) {
  const Mission& mission = config.mission;
  const Footprint& footprint = config.vehicle.footprint;
  if (footprint.is_disc()) {
    free.mark_disc(mission.start_world, config.vehicle.body_radius_m);
    return;
  }
  std::vector<Vec2> corners_world;
  place_corners(footprint.corners_body, mission.start_world, mission.start_heading, corners_world);
  free.mark_convex(corners_world);
}

// What turns round on the spot before it drives stands for its sake.
double stall_timeout_s(const NavigatorConfig& config) {
  const bool turns_first =
      config.navigation.governor && config.vehicle.steering == Steering::along_heading;
  return config.navigation.stall_timeout_s + (turns_first ? kTurnRound_s : 0);
}

// Tells the observer, if there is one, of a stage for as long as it lives.
class StageNotice {
 public:
  StageNotice(NavigationObserver* observer, NavigationObserver::Stage stage)
      : observer_(observer), stage_(stage) {
    if (observer_ != nullptr) observer_->stage_begins(stage_);
  }
  StageNotice(const StageNotice&) = delete;
  StageNotice& operator=(const StageNotice&) = delete;
  ~StageNotice() {
    if (observer_ != nullptr) observer_->stage_ends(stage_);
  }

 private:
  NavigationObserver* observer_;
  NavigationObserver::Stage stage_;
};

}  // namespace

Navigator::Navigator(const NavigatorConfig& config, const PlannerCatalog& planners)
    : config_(config),
      map_(config.mapping),
      free_space_(free_space_of(config)),
      doubted_(config.errors.sensing, config.vehicle.body_radius_m),
      problem_(problem_config(config)),
      planner_traits_(planner_entry(config, planners).traits),
      planner_(make_planner(config, planners, problem_)),
      replan_policy_(config.navigation, planner_traits_),
      tracker_(config.navigation, SpeedProfile(goal_profile(config)),
               config.vehicle.limits.max_speed_m_s),
      yaw_policy_(config.navigation.yaw_policy, config.mission.start_heading),
      look_around_(config.range_finder.field_of_view_rad),
      recovery_(stall_timeout_s(config)),
      braking_{config.vehicle.velocity_gain_1_s, config.vehicle.deceleration_m_s2,
               config.vehicle.planning_clearance_m},
      governor_(governor_of(config)) {
  asks_for_fit_ = config.vehicle.planned_smaller();
  if (governor_) mark_start(config, free_space_);
}

Setpoint Navigator::update(const Scan& scan, const VehicleState& state, double now_s) {
  map(scan);
  plan(state, now_s);
  return steer(state, now_s);
}

void Navigator::map(const Scan& scan) {
  const StageNotice notice(observer_, NavigationObserver::Stage::mapping);
  scan_ = scan;
  map_.update(scan_);
  if (governor_) free_space_.update(config_.errors.sensing.none() ? scan_ : doubted_.of(scan_));
  belief_ = {virtual_obstacles_.over(map_.snapshot()), &scan_, map_.scan_clusters(),
             scan_.sensor_world};
  scan_is_new_ = true;
  report_.replan = ReplanReason::none;
  report_.planner_mode.clear();
  report_.infeasible.clear();
}

void Navigator::plan(const VehicleState& state, double now_s) {
  const StageNotice notice(observer_, NavigationObserver::Stage::planning);
  note_arrival(state);
  if (!report_.departed_s && !depart(state, now_s)) return;
  const Vec2& p = belief_.pose_world.p_world;
  if (config_.navigation.recovery) recover(state, now_s);
  problem_.update(belief_, p);
  tracker_.advance(p);
  follow_trail(p);
  report_.replan = replan_policy_.reason(tracker_, problem_.geometry(), p, now_s);
  if (report_.replan == ReplanReason::none) return;

  Plan plan = plan_that_fits();
  report_.solve_end = plan.end;
  report_.planner_mode = plan.mode;
  adopt(std::move(plan));
}

// What is planned as a smaller disc than holds it may not get along every path. Where it would
// touch what is known, planners get a virtual obstacle and are asked again.
Plan Navigator::plan_that_fits() {
  const Vec2& p = belief_.pose_world.p_world;
  Plan plan = ask_from(p);
  for (int tries = 0; asks_for_fit_ && tries < kTriesToFit && !plan.path.empty(); ++tries) {
    const auto misfit = first_misfit(config_.vehicle.footprint, plan.path, map_.snapshot());
    // Where it stands, the governor decides alone.
    const double away_m = misfit ? (*misfit - plan.path.front()).norm() : 0;
    if (away_m < config_.vehicle.body_radius_m) break;
    virtual_obstacles_.add(*misfit);
    belief_.obstacles = virtual_obstacles_.over(map_.snapshot());
    problem_.update(belief_, p);
    plan = ask_from(p);
  }
  return plan;
}

bool Navigator::depart(const VehicleState& state, double now_s) {
  if (report_.executive == ExecutiveState::takeoff) {
    const double error_m = state.p_world.z() - config_.mission.cruise_height_m;
    const bool risen =
        std::abs(error_m) < kHeightReached_m && std::abs(state.v_world.z()) < kHeightReached_m_s;
    if (!risen) return false;
    if (config_.navigation.look_around) look_around_.begin(state.heading_world());
  }
  look_around(state);
  if (look_around_.active()) {
    report_.executive = ExecutiveState::looking_around;
    return false;
  }
  report_.departed_s = now_s;
  return true;
}

void Navigator::look_around(const VehicleState& state) {
  const bool refused = sweeps_by_turning() && report_.executive == ExecutiveState::looking_around &&
                       report_.speed_scale == 0;
  if (refused) look_around_.give_up();
  look_around_.advance(state.heading_world());
}

void Navigator::follow_trail(const Vec2& p_world) {
  if (!retracing_) {
    trail_.extend(p_world);
    return;
  }
  trail_.backtrack(p_world);
  if (tracker_.remaining_m() < BreadcrumbTrail::kSpacing_m) tracker_.drop();  // ask from here
}

// Down a ladder of clearances, as long as no path is found: what is off makes gaps look narrower,
// and where there is room for it vehicles go faster. The path is then followed at the clearance at
// which it was found.
Plan Navigator::ask_from(const Vec2& start_world) {
  for (const double share : {1.0, 0.5, 0.0}) {
    const double room_m = share * config_.errors.planning_room_m;
    if (config_.errors.planning_room_m > 0) {
      problem_.keep(config_.vehicle.planning_clearance_m + room_m);
      problem_.update(belief_, start_world);
    }
    Plan plan = ask_for_plan(*planner_, planner_traits_, problem_, config_.budget);
    if (!plan.path.empty() || room_m == 0) return plan;
  }
  return {};
}

void Navigator::adopt(Plan plan) {
  const bool proof_holds = virtual_obstacles_.empty();
  if (plan.status == PlanStatus::infeasible && proof_holds) {
    judge_infeasible();
    return;
  }
  report_.refusal = plan.refusal;
  if (plan.path.empty()) {
    if (!retracing_) tracker_.drop();
    return;
  }
  retracing_ = false;
  if (config_.navigation.shortcut && !planner_traits_.plans_on_every_scan)
    plan.path = shortcut(plan.path, problem_.geometry());
  follow(std::move(plan.path), plan.status == PlanStatus::to_goal ? PathEnd::goal : PathEnd::leg);
}

// That no path exists from here may be the vehicle's own doing: it stands in a pocket that it came
// into through a passage too narrow for planners. What counts is whether the mission has a path.
void Navigator::judge_infeasible() {
  tracker_.drop();
  problem_.update(belief_, config_.mission.start_world);
  const Plan from_start = ask_for_plan(*planner_, planner_traits_, problem_, config_.budget);
  problem_.update(belief_, belief_.pose_world.p_world);
  if (from_start.status == PlanStatus::infeasible) {
    report_.infeasible = problem_.goal_has_place()
                             ? "the planner proved that no path exists"
                             : "no place at the goal keeps the clearance from what is known";
  } else if (config_.navigation.recovery) {
    retrace();
  }
}

void Navigator::retrace() {
  retracing_ = true;
  Path back = trail_.path_back(belief_.pose_world.p_world, kRetraceLeg_m);
  if (!back.empty()) follow(std::move(back), PathEnd::goal);
}

void Navigator::follow(Path path, PathEnd end) {
  if (observer_ != nullptr) observer_->path_adopted(path);
  tracker_.follow(std::move(path), end);
}

void Navigator::note_arrival(const VehicleState& state) {
  const Vec2 to_goal = state.p_world.head<2>() - config_.mission.goal_world;
  arrived_ = arrived_ || to_goal.norm() <= config_.mission.goal_tolerance_m;
}

}  // namespace voronaut
