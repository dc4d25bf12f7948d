#include <algorithm>
#include <cmath>
#include <utility>

#include "voronaut/planners/navigation/departure.h"
#include "voronaut/planners/navigation/navigator.h"

// Where to go now, how fast, and what the governor says to it.
namespace voronaut {

namespace {

// A repulsion is at most this many times as strong as the wish to go on.
constexpr double kRepulsionMax = 2;
// What is left of a direction and a repulsion that cancel has none.
constexpr double kNoDirection = 0.1;
// Beyond what the governor keeps from the bounds, a heading turns inwards within so much.
constexpr double kRoomToBounds_m = 0.02;
// The way to the lookahead point comes so much closer to known points than planners plan, or so
// much closer than it is.
constexpr double kSwing_m = 0.01;
constexpr double kCloser_m = 0.002;
// Leaving what its tube touches: from standing, along a line, until it is so far from it. A course
// along a wall drifts towards it, so what is nearly touched holds it up, too.
constexpr double kStandsStill_m_s = 0.1;
constexpr double kStraightAhead_m = 1;
constexpr double kLeft_m = 0.008;
constexpr double kTouched_m = kDepartureDrift_m;

// These lead back to where the vehicle came from: nothing there needs looking at.
bool leads_back(ExecutiveState state) {
  return state == ExecutiveState::backing_off || state == ExecutiveState::retracing;
}

}  // namespace

Setpoint Navigator::steer(const VehicleState& state, double now_s) {
  note_arrival(state);
  const bool scan_is_new = std::exchange(scan_is_new_, false);
  if (governor_ && !scan_is_new) return report_.setpoint;
  const Vec2 p = state.p_world.head<2>();
  Setpoint setpoint;
  setpoint.height_m = config_.mission.cruise_height_m;
  setpoint.heading_world = yaw_policy_.heading(tracker_, p, unknown_to_look_at(state));
  const LookaheadPoint ahead = lookahead(state, now_s, setpoint);
  const Vec2 way = ahead.p_world - p;
  const KnownClearance kept = retracing_ || now_s < reduced_clearance_until_s_
                                  ? KnownClearance::reduced
                                  : KnownClearance::planned;
  Vec2 towards = way.norm() > 0 ? Vec2(way.normalized()) : setpoint.heading_world;
  if (way.norm() > 0 && kept == KnownClearance::planned) towards = repulsive_heading(towards, p);
  towards = kept_within_bounds(towards, state);
  const double speed_m_s =
      speed_limit_m_s(config_.navigation.speed_rule, belief_, towards, braking_,
                      config_.navigation.reaction_time_s, ahead.speed_limit_m_s);
  if (governor_) {
    WantedMotion wanted{.v_world = looks_at_ ? Vec2(0, 0) : Vec2(speed_m_s * towards),
                        .heading_world = setpoint.heading_world,
                        .yaw_rate_rad_s = setpoint.yaw_rate_rad_s,
                        .lookahead_m = way.norm(),
                        .may_reverse = leads_back(report_.executive)};
    leave_what_it_touches(wanted, state, kept);
    std::visit([&](const auto& command) { setpoint.motion = command; },
               govern(wanted, state, kept));
  } else if (ahead.end == PathEnd::goal) {
    setpoint.motion = RestAtTarget{ahead.p_world, speed_m_s};
  } else {
    setpoint.motion = PassTarget{ahead.p_world, speed_m_s, ahead.segment};
  }
  report_.lookahead_world = ahead.p_world;
  report_.setpoint = setpoint;
  return setpoint;
}

// The point to head for; on the spot, unless there is a reason to go. Says what the executive is
// about, and how fast to turn.
LookaheadPoint Navigator::lookahead(const VehicleState& state, double now_s, Setpoint& setpoint) {
  const Vec2 p = state.p_world.head<2>();
  const bool departed = report_.departed_s.has_value();
  const LookaheadPoint here{.p_world = p};
  if (look_around_.active()) {
    report_.executive = ExecutiveState::looking_around;
    setpoint.heading_world = state.heading_world();
    setpoint.yaw_rate_rad_s = config_.vehicle.limits.max_yaw_rate_rad_s;
    return here;
  }
  if (departed && now_s < back_off_until_s_) {
    report_.executive = ExecutiveState::backing_off;
    const auto obstacle = nearest_obstacle_within_clearance(p);
    const auto from = obstacle ? obstacle : back_off_from_;
    return from ? LookaheadPoint{p + (p - *from).normalized(), kBackOff_m_s} : here;
  }
  if (tracker_.has_path()) {
    report_.executive = retracing_ ? ExecutiveState::retracing : ExecutiveState::tracking;
    setpoint.yaw_rate_rad_s =
        yaw_policy_.yaw_rate_rad_s(setpoint.heading_world, state.heading_world());
    tracker_.advance(p);
    return tracker_.lookahead(p, state.v_world.head<2>().norm(), belief_.obstacles,
                              lookahead_clearance_m(p));
  }
  if (departed) report_.executive = ExecutiveState::without_path;
  return here;
}

// What the way to the lookahead point keeps from known points. A governed vehicle on wheels swings
// about its path; with all that planners keep, the point would come so near in a passage as wide as
// they plan for that the swings grow. What is closer already need not get away on its way there.
double Navigator::lookahead_clearance_m(const Vec2& p_world) const {
  const double clearance_m = config_.vehicle.planning_clearance_m;
  if (!governs_wheels()) return clearance_m;
  if (!governs_turning_wheels()) return kept_from_known_m();
  const auto nearest = nearest_obstacle_within_clearance(p_world);
  const double now_m = nearest ? (*nearest - p_world).norm() : clearance_m;
  return std::min(clearance_m - kSwing_m, now_m - kCloser_m);
}

// How close the governor lets a vehicle come to known points.
double Navigator::kept_from_known_m() const {
  return config_.vehicle.planning_clearance_m - SafetyGovernor::kKnownMargin_m;
}

bool Navigator::governs_wheels() const {
  return governor_ && config_.vehicle.steering == Steering::along_heading;
}

// That can turn where it stands.
bool Navigator::governs_turning_wheels() const {
  return governs_wheels() &&
         std::holds_alternative<DriveResponse>(*config_.vehicle.motion_response);
}

// A vehicle on wheels that stands where its tube touches cells on a wall, or as close to a known
// point as it may, can only go where it leaves all of them behind. The way that it wants seldom
// does, and turning to it and back it would stand for ever: it turns no farther than it must, backs
// out if that way lies behind, and goes on once it has left them by kLeft_m.
void Navigator::leave_what_it_touches(WantedMotion& wanted, const VehicleState& state,
                                      KnownClearance kept) {
  const double speed_m_s = state.v_world.head<2>().norm();
  const bool leaves = std::exchange(leaves_, false);
  if (!governs_turning_wheels() || wanted.v_world.isZero() || speed_m_s > kDepartureSpeed_m_s)
    return;
  const auto* before = std::get_if<ArcCommand>(&report_.setpoint.motion);
  const bool held_back = report_.speed_scale < kHeldBackScale;
  const bool stands =
      before != nullptr && (held_back || before->v_m_s == 0) && speed_m_s < kStandsStill_m_s;
  if (!leaves && !stands) return;
  const Vec2 p = state.p_world.head<2>();
  const double near_m = leaves ? kLeft_m : kTouched_m;
  std::optional<Vec2> known_point;
  if (kept == KnownClearance::planned) {
    const ObstacleSnapshot known = map_.snapshot();
    if (const auto nearest = known.nearest(p, kept_from_known_m() + near_m))
      known_point = known.points()[*nearest];
  }
  const double wanted_m_s = wanted.v_world.norm();
  const bool goes_on = leaves && sweeps_by_turning();
  const Vec2 towards = goes_on ? left_along_ : Vec2(wanted.v_world / wanted_m_s);
  const auto away = governor_->way_out(towards, state, near_m, free_space_, known_point);
  if (!away) return;
  left_along_ = *away;
  leaves_ = true;
  wanted.v_world = wanted_m_s * *away;
  wanted.lookahead_m = kStraightAhead_m;
  wanted.may_reverse = true;
}

// Closer to a known point than planners plan, a heading also leads away from it; on wheels, which
// would have to turn for that, only closer than the governor lets it come.
Vec2 Navigator::repulsive_heading(const Vec2& towards, const Vec2& p_world) const {
  const auto nearest = nearest_obstacle_within_clearance(p_world);
  if (!governor_ || !nearest) return towards;
  const Vec2 from_nearest = p_world - *nearest;
  const double distance_m = from_nearest.norm();
  if (distance_m == 0) return towards;
  const double keep_m =
      governs_wheels() ? kept_from_known_m() : config_.vehicle.planning_clearance_m;
  const double too_close_m = keep_m - distance_m;
  if (too_close_m <= 0) return towards;
  const double repulsion = std::min(kRepulsionMax, too_close_m / SafetyGovernor::kKnownMargin_m);
  const Vec2 blended = towards + (repulsion / distance_m) * from_nearest;
  return blended.norm() > kNoDirection ? Vec2(blended.normalized())
                                       : Vec2(from_nearest / distance_m);
}

// Beside the bounds, where the governor lets nothing go on outwards, a heading leads along them and
// inwards.
Vec2 Navigator::kept_within_bounds(const Vec2& towards, const VehicleState& state) const {
  if (!governor_) return towards;
  const double room_m = governor_->room_to_bounds_m(state) + kRoomToBounds_m;
  const Vec2 p = state.p_world.head<2>();
  const Bounds& bounds = config_.mission.bounds_world;
  Vec2 kept = towards;
  for (const int axis : {0, 1}) {
    for (const double inwards : {1.0, -1.0}) {
      const double inside_m = inwards > 0 ? p[axis] - bounds.min[axis] : bounds.max[axis] - p[axis];
      if (inside_m >= room_m) continue;
      const double repulsion = std::min(kRepulsionMax, (room_m - inside_m) / kRoomToBounds_m);
      kept[axis] = inwards * (std::max(0.0, inwards * kept[axis]) + repulsion);
    }
  }
  return kept.norm() > kNoDirection ? Vec2(kept.normalized()) : towards;
}

MotionCommand Navigator::govern(const WantedMotion& wanted, const VehicleState& state,
                                KnownClearance kept) {
  const GovernedMotion& allowed =
      governor_->allow(wanted, state, free_space_, map_.snapshot(), kept);
  refused_at_ = allowed.refused_at;
  report_.speed_scale = allowed.speed_scale;
  report_.tube_world = allowed.tube_world;
  return allowed.command;
}

}  // namespace voronaut
