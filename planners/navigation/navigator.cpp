#include "voronaut/planners/navigation/navigator.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "voronaut/planners/navigation/shortcut.h"

// When to set off, when to plan, and what to make of the planner's answer.
namespace voronaut {

namespace {

// What a body within the bounds may touch.
Bounds reachable_bounds(const NavigatorConfig& config) {
  const Bounds& bounds = config.mission.bounds_world;
  const Vec2 rim(config.vehicle.planning_clearance_m, config.vehicle.planning_clearance_m);
  return {bounds.min - rim, bounds.max + rim};
}

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

std::optional<SafetyGovernor> governor_of(const NavigatorConfig& config) {
  if (!config.navigation.governor) return std::nullopt;
  const VehicleFacts& vehicle = config.vehicle;
  if (!vehicle.motion_response)
    throw std::invalid_argument(
        "a governor needs the vehicle's motion response (else navigation.governor = false)");
  const bool answers_arcs = !std::holds_alternative<VelocityResponse>(*vehicle.motion_response);
  if (answers_arcs != (vehicle.steering == Steering::along_heading))
    throw std::invalid_argument(
        "a governor needs a motion response of the kind of the vehicle's steering");
  return SafetyGovernor(*vehicle.motion_response, vehicle.body_radius_m,
                        vehicle.planning_clearance_m, config.range_finder.period_s,
                        config.mission.bounds_world);
}

// How far a vehicle's course swings from its path towards a wall, at a corner or braking, in the
// worst of the flights by which this was chosen.
constexpr double kSwingAside_m = 0.025;
// Finer cells cost more than they give: an update takes 10 k instructions at 0.05 m, 22 k at 0.015
// m, 34 k at 0.01 m (91 rays).
constexpr double kFinestCell_m = 0.01;

// Cells on a wall are never known free. So a tube keeps a cell's diagonal from it, and what
// planners keep beside the body must have room for that, for what a stop strays, and for the swing:
// at 4 cm vehicles stand still before gaps that their paths lead through with cells of 0.05 m, 5 of
// 200 with 0.02 m, none of 500 with 0.015 m.
double cell_m(const NavigatorConfig& config) {
  const double coarsest_m = FreeSpaceConfig{}.cell_m;
  const auto governor = governor_of(config);
  if (!governor) return coarsest_m;
  const double beside_body_m = config.vehicle.planning_clearance_m - config.vehicle.body_radius_m;
  const double stray_m = governor->room_to_bounds_m(VehicleState{});
  const double diagonal_m = beside_body_m - stray_m - kSwingAside_m;
  return std::clamp(diagonal_m / std::numbers::sqrt2, kFinestCell_m, coarsest_m);
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
      free_space_(reachable_bounds(config), {.cell_m = cell_m(config)}),
      problem_(problem_config(config)),
      planner_traits_(planner_entry(config, planners).traits),
      planner_(make_planner(config, planners, problem_)),
      replan_policy_(config.navigation, planner_traits_),
      tracker_(config.navigation, SpeedProfile(config.vehicle.goal_profile),
               config.vehicle.limits.max_speed_m_s),
      yaw_policy_(config.navigation.yaw_policy, config.mission.start_heading),
      look_around_(config.range_finder.field_of_view_rad),
      recovery_(stall_timeout_s(config)),
      braking_{config.vehicle.velocity_gain_1_s, config.vehicle.deceleration_m_s2,
               config.vehicle.planning_clearance_m},
      governor_(governor_of(config)) {
  if (governor_) free_space_.mark_disc(config.mission.start_world, config.vehicle.body_radius_m);
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
  if (governor_) free_space_.update(scan_);
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

  Plan plan = ask_for_plan(*planner_, planner_traits_, problem_, config_.budget);
  report_.solve_end = plan.end;
  report_.planner_mode = plan.mode;
  adopt(std::move(plan));
}

bool Navigator::depart(const VehicleState& state, double now_s) {
  if (report_.executive == ExecutiveState::takeoff) {
    const double error_m = state.p_world.z() - config_.mission.cruise_height_m;
    const bool risen =
        std::abs(error_m) < kHeightReached_m && std::abs(state.v_world.z()) < kHeightReached_m_s;
    if (!risen) return false;
    if (config_.navigation.look_around) look_around_.begin(state.heading_world());
  }
  look_around_.advance(state.heading_world());
  if (look_around_.active()) {
    report_.executive = ExecutiveState::looking_around;
    return false;
  }
  report_.departed_s = now_s;
  return true;
}

void Navigator::follow_trail(const Vec2& p_world) {
  if (!retracing_) {
    trail_.extend(p_world);
    return;
  }
  trail_.backtrack(p_world);
  if (tracker_.remaining_m() < BreadcrumbTrail::kSpacing_m) tracker_.drop();  // ask from here
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
