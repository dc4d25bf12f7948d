#include <cmath>

#include "voronaut/dynamics/heading.h"
#include "voronaut/planners/navigation/navigator.h"

// What to do when the vehicle does not get on: which step is recovery.h's to say.
namespace voronaut {

namespace {

// Shares of half the field of view.
constexpr double kOutOfView = 0.9;
constexpr double kWellInView = 0.6;
// A polygon that comes no farther than this in that time goes to and fro before a corner.
constexpr double kPace_m = 0.1;
constexpr double kPacing_s = 2;

}  // namespace

// The known point that is closer to p than planners plan, or that the corners of what is planned
// smaller come as close to as planners let its sides.
std::optional<Vec2> Navigator::nearest_obstacle_within_clearance(const Vec2& p_world) const {
  const ObstacleSnapshot known = map_.snapshot();
  const auto nearest = known.nearest(p_world, clearance_of_corners_m());
  return nearest ? std::optional(known.points()[*nearest]) : std::nullopt;
}

// An unknown place as close as that, for which the governor refused.
std::optional<Vec2> Navigator::nearest_unknown_within_clearance(const Vec2& p_world) const {
  const bool near = refused_at_ && (*refused_at_ - p_world).norm() < clearance_of_corners_m();
  return near ? refused_at_ : std::nullopt;
}

double Navigator::clearance_of_corners_m() const {
  const VehicleFacts& vehicle = config_.vehicle;
  if (!vehicle.planned_smaller()) return vehicle.planning_clearance_m;
  return vehicle.planning_clearance_m + vehicle.body_radius_m - vehicle.footprint.planned_radius_m;
}

std::optional<Vec2> Navigator::nearest_within_clearance(const Vec2& p_world) const {
  const auto obstacle = nearest_obstacle_within_clearance(p_world);
  return obstacle ? obstacle : nearest_unknown_within_clearance(p_world);
}

// For whose sake the governor keeps the vehicle from moving on.
std::optional<Vec2> Navigator::unknown_that_holds_back(const VehicleState& state) const {
  const bool held_back =
      report_.speed_scale < kHeldBackScale && state.v_world.head<2>().norm() < kHeldBack_m_s;
  return held_back ? refused_at_ : std::nullopt;
}

// What moves in any direction looks there as it goes. What drives along its heading turns to the
// place first if it is out of view, on the spot, until it has it well in view; not if it may lack
// the room for that.
std::optional<Vec2> Navigator::unknown_to_look_at(const VehicleState& state) {
  const auto held_back_by = unknown_that_holds_back(state);
  if (!governs_wheels() || sweeps_by_turning()) return held_back_by;
  const auto off_view = [&](const Vec2& place, double share) {
    const Vec2 way = place - state.p_world.head<2>();
    if (way.norm() == 0) return false;
    const double off_rad = heading_error_rad(state.heading_world(), way.normalized());
    return std::abs(off_rad) > share * 0.5 * config_.range_finder.field_of_view_rad;
  };
  if (!looks_at_ && held_back_by && off_view(*held_back_by, kOutOfView) &&
      !is_on_surface(*held_back_by))
    looks_at_ = held_back_by;
  if (looks_at_ && (free_space_.is_free(*looks_at_) || !off_view(*looks_at_, kWellInView)))
    looks_at_.reset();
  return looks_at_;
}

// A cell on a surface that has been seen never becomes known free, however often it is looked at.
// Every return has a known point closer than the thinning distance.
bool Navigator::is_on_surface(const Vec2& unknown_world) const {
  const double near_m = config_.mapping.thinning_distance_m + 2 * free_space_.part_radius_m();
  return map_.snapshot().nearest(unknown_world, near_m).has_value();
}

void Navigator::recover(const VehicleState& state, double now_s) {
  const bool was_looking = look_around_.active();
  look_around(state);
  if (was_looking && !look_around_.active()) tracker_.drop();  // plan anew with what was seen
  if (was_looking || now_s < back_off_until_s_ || arrived_) {
    recovery_.resume();
    return;
  }
  const Vec2 p = state.p_world.head<2>();
  if ((p - paces_at_).norm() > kPace_m) {
    paces_at_ = p;
    paces_since_s_ = now_s;
  }
  const bool paces = sweeps_by_turning() && now_s - paces_since_s_ > kPacing_s;
  const MissionProgress progress{
      .now_s = now_s,
      .p_world = p,
      .speed_m_s = paces ? 0 : state.v_world.head<2>().norm(),
      .wants_to_move = tracker_.has_path(),
      .obstacle_within_clearance = nearest_obstacle_within_clearance(p).has_value(),
      .unknown_within_clearance = nearest_unknown_within_clearance(p).has_value(),
      .virtual_in_force = !virtual_obstacles_.empty()};
  act(recovery_.advise(progress), state, now_s);
}

void Navigator::act(RecoveryAction action, const VehicleState& state, double now_s) {
  const bool turns_first = config_.vehicle.steering == Steering::along_heading;
  switch (action) {
    case RecoveryAction::none:
      return;
    case RecoveryAction::back_off:
      back_off_until_s_ = now_s + kBackOff_s + (turns_first ? kTurnRound_s : 0);
      back_off_from_ = nearest_within_clearance(state.p_world.head<2>());
      return;
    case RecoveryAction::reduce_clearance:
      reduced_clearance_until_s_ = now_s + kReducedClearance_s;
      return;
    case RecoveryAction::retrace:
      retrace();
      return;
    case RecoveryAction::drop_virtual_obstacles:
      virtual_obstacles_.clear();
      asks_for_fit_ = false;
      break;
    case RecoveryAction::add_virtual_obstacle:
      if (!refused_at_) break;
      virtual_obstacles_.add(*refused_at_);
      belief_.obstacles = virtual_obstacles_.over(map_.snapshot());
      tracker_.drop();
      return;
    case RecoveryAction::look_around:
      break;
  }
  belief_.obstacles = virtual_obstacles_.over(map_.snapshot());
  look_around_.begin(state.heading_world());
}

}  // namespace voronaut
