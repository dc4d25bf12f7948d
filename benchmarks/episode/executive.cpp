#include <cmath>

#include "voronaut/benchmarks/episode/episode.h"

// The executive's half of a flight: when to set off, what to do when it does not go on, and which
// setpoint comes out. Every decision is a policy's of planners/navigation.
namespace voronaut {

namespace {

// The papers' vehicle rises before it sets off: it has its height when it is this close and this
// slow.
constexpr double kHeightReached_m = 0.05;
constexpr double kHeightReached_m_s = 0.1;
constexpr double kBackOff_s = 2;
constexpr double kBackOff_m_s = 0.3;
constexpr double kTurnRound_s = 2;  // what looks where it drives does that before it backs off
constexpr double kSqueeze_s = 4;
constexpr double kHeldBackShare = 0.2;
constexpr double kHeldBack_m_s = 0.3;

}  // namespace

bool Flight::depart(const VehicleState& state, double now_s) {
  if (executive == ExecutiveState::rising) {
    const double error_m = state.p_world.z() - spec.scenario.cruise_height_m;
    const bool risen =
        std::abs(error_m) < kHeightReached_m && std::abs(state.v_world.z()) < kHeightReached_m_s;
    if (!risen) return false;
    if (spec.flight.navigation.look_around) look_around.begin(state.heading_world());
  }
  look_around.advance(state.heading_world());
  if (look_around.active()) {
    executive = ExecutiveState::looking_around;
    return false;
  }
  departed = true;
  log.departure_s = now_s;
  return true;
}

// The known point that is closer to p than planners plan.
std::optional<Vec2> Flight::crowding(const Vec2& p_world) const {
  const ObstacleSnapshot known = map.snapshot();
  const auto nearest = known.nearest(p_world, spec.vehicle.planning_clearance_m);
  return nearest ? std::optional(known.points()[*nearest]) : std::nullopt;
}

// An unknown place as close as that, for which the governor refused.
std::optional<Vec2> Flight::hemming_in(const Vec2& p_world) const {
  const bool near =
      refused_at && (*refused_at - p_world).norm() < spec.vehicle.planning_clearance_m;
  return near ? refused_at : std::nullopt;
}

// The unknown for whose sake the governor keeps the vehicle from moving on.
std::optional<Vec2> Flight::in_doubt(const VehicleState& state) const {
  const bool held_back = log.scans.size() > 1 &&
                         log.scans[log.scans.size() - 2].governed_share < kHeldBackShare &&
                         state.v_world.head<2>().norm() < kHeldBack_m_s;
  return held_back ? refused_at : std::nullopt;
}

void Flight::recover(const VehicleState& state, double now_s) {
  const bool was_looking = look_around.active();
  look_around.advance(state.heading_world());
  if (was_looking && !look_around.active()) tracker.drop();  // plan anew with what was seen
  if (was_looking || now_s < back_off_until_s || referee.arrived_s()) {
    recovery.resume();
    return;
  }

  const Vec2 p = state.p_world.head<2>();
  switch (recovery.advise({now_s, p, state.v_world.head<2>().norm(), tracker.has_path(),
                           crowding(p).has_value(), hemming_in(p).has_value(),
                           !virtual_obstacles.empty()})) {
    case RecoveryAction::none:
      return;
    case RecoveryAction::back_off:
      back_off_until_s = now_s + kBackOff_s + (is_wheeled(spec.vehicle) ? kTurnRound_s : 0);
      back_off_from = crowding(p) ? crowding(p) : hemming_in(p);
      return;
    case RecoveryAction::squeeze:
      squeeze_until_s = now_s + kSqueeze_s;
      return;
    case RecoveryAction::retrace:
      retrace();
      return;
    case RecoveryAction::drop_virtual_obstacles:
      virtual_obstacles.clear();
      break;
    case RecoveryAction::add_virtual_obstacle:
      if (!refused_at) break;
      virtual_obstacles.add(*refused_at);
      belief.obstacles = virtual_obstacles.over(map.snapshot());
      tracker.drop();
      return;
    case RecoveryAction::look_around:
      break;
  }
  belief.obstacles = virtual_obstacles.over(map.snapshot());
  look_around.begin(state.heading_world());
}

// Closer to a known point than planners plan, a course also leads away from it.
Vec2 Flight::leaning_away(const Vec2& towards, const Vec2& p_world) const {
  const auto nearest = crowding(p_world);
  if (!governor || !nearest) return towards;
  const Vec2 from_nearest = p_world - *nearest;
  const double distance_m = from_nearest.norm();
  if (distance_m == 0) return towards;
  const double lean = std::min(
      2.0, (spec.vehicle.planning_clearance_m - distance_m) / SafetyGovernor::kKnownMargin_m);
  const Vec2 blended = towards + (lean / distance_m) * from_nearest;
  return blended.norm() > 0.1 ? Vec2(blended.normalized()) : Vec2(from_nearest / distance_m);
}

Setpoint Flight::navigate(const VehicleState& state, double now_s) {
  const bool scanned_now = log.scans.back().tick + 1 == log.ticks.size();
  if (governor && !scanned_now) return held;
  const Vec2 p = state.p_world.head<2>();
  Setpoint setpoint;
  setpoint.p_target_world = Vec3(p.x(), p.y(), spec.scenario.cruise_height_m);
  setpoint.heading_world = gaze.heading(tracker, p, in_doubt(state));

  Aim aim{p, 0, false};
  if (look_around.active()) {
    executive = ExecutiveState::looking_around;
    setpoint.heading_world = state.heading_world();
    setpoint.yaw_rate_rad_s = spec.vehicle.limits.max_yaw_rate_rad_s;
  } else if (departed && now_s < back_off_until_s) {
    executive = ExecutiveState::backing_off;
    const auto place = crowding(p) ? crowding(p) : back_off_from;
    if (place) aim = {p + (p - *place).normalized(), kBackOff_m_s, false};
  } else if (tracker.has_path()) {
    executive = retracing ? ExecutiveState::retracing : ExecutiveState::under_way;
    setpoint.yaw_rate_rad_s = gaze.yaw_rate_rad_s(setpoint.heading_world, state.heading_world());
    tracker.advance(p);
    aim = tracker.aim(p, state.v_world.head<2>().norm(), belief.obstacles,
                      spec.vehicle.planning_clearance_m);
  } else if (departed) {
    executive = ExecutiveState::without_path;
  }

  setpoint.p_target_world.head<2>() = aim.p_target_world;
  setpoint.brake_at_target = aim.at_goal;
  setpoint.piece = aim.piece;
  const Vec2 way = aim.p_target_world - p;
  const bool squeezing = retracing || now_s < squeeze_until_s;
  Vec2 towards = way.norm() > 0 ? Vec2(way.normalized()) : setpoint.heading_world;
  if (way.norm() > 0 && !squeezing) towards = leaning_away(towards, p);
  setpoint.speed_limit_m_s =
      speed_limit_m_s(spec.flight.navigation.speed_rule, belief, towards, braking,
                      spec.flight.navigation.reaction_time_s, aim.speed_limit_m_s);
  if (governor) govern(state, towards, squeezing, setpoint);
  return setpoint;
}

void Flight::govern(const VehicleState& state, const Vec2& towards, bool squeezing,
                    Setpoint& setpoint) {
  const Vec2 v_wanted = setpoint.speed_limit_m_s * towards;
  const GovernedCourse& course =
      governor->allow(v_wanted, state, free_space, map.snapshot(), squeezing);
  setpoint.course_m_s = course.v_world;
  refused_at = course.refused_at;
  log.scans.back().governed_share = course.share;
  if (keep_scans) log.scans.back().tube = course.tube_world;
  held = setpoint;
}

}  // namespace voronaut
