#include "voronaut/planners/navigation/arc_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voronaut {

namespace {

constexpr std::array kArcScales = {0.05, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0};
// Off its heading by more than 10 deg, it rather turns on the spot than go slower than a quarter.
constexpr double kStraightCosine = 0.985;
constexpr std::size_t kSlowArcs = 2;
// On the spot, from level 1 on.
constexpr std::array kTurnInSteps = {0.08, 0.3, 1.0};
constexpr std::array kTurnAtOnce = {1.0};
// A point nearer than this to where it will be then is as good as passed.
constexpr double kPassed_m = 0.03;

// Where it will be, if it goes on as it does; angles are small.
DriveMotion led(const DriveMotion& now, double lead_s) {
  const Vec2 turned = lead_s * now.w_rad_s * left_of(now.heading);
  DriveMotion then = now;
  then.p_m += lead_s * now.v_m_s * (now.heading + 0.5 * turned).normalized();
  then.heading = (now.heading + turned).normalized();
  return then;
}

}  // namespace

ArcLadder::ArcLadder(const DriveResponse& response, bool turns_in_steps)
    : response_(response),
      turn_scales_(turns_in_steps ? std::span<const double>(kTurnInSteps)
                                  : std::span<const double>(kTurnAtOnce)) {}

void ArcLadder::set_up(const WantedMotion& wanted, const VehicleState& state) {
  now_ = response_.motion_of(state);
  const ArcLimits& limits = response_.limits;
  const double speed_m_s = wanted.v_world.norm();
  if (speed_m_s == 0) {
    full_ = turn_ = {
        0, turn_rate_rad_s(now_.heading, wanted.heading_world, wanted.yaw_rate_rad_s, limits)};
    return;
  }
  const Vec2 towards = wanted.v_world / speed_m_s;
  const Vec2 way_m = wanted.lookahead_m * towards;
  const bool backwards = wanted.may_reverse && now_.heading.dot(towards) < 0;
  const Vec2 front = backwards ? Vec2(-now_.heading) : now_.heading;
  full_ = backwards ? arc_back_towards(now_.heading, way_m, speed_m_s, now_.v_m_s, limits)
                    : arc_ahead(way_m, speed_m_s);
  turn_ = {0, full_.v_m_s == 0 ? full_.w_rad_s : turn_rate_rad_s(front, towards, 0, limits)};
  scales_ = kArcScales;
  if (front.dot(towards) < kStraightCosine) scales_ = scales_.subspan(kSlowArcs);
}

// The yaw rate lags by the time constant of its loop. So the arc is the one from where the vehicle
// will be by then: the one from where it is would come late, and swing about the path.
ArcCommand ArcLadder::arc_ahead(const Vec2& way_m, double speed_m_s) const {
  const ArcLimits& limits = response_.limits;
  const ArcCommand from_here = arc_towards(now_.heading, way_m, speed_m_s, now_.v_m_s, limits);
  if (from_here.v_m_s == 0 || now_.v_m_s <= 0) return from_here;
  const DriveMotion then = led(now_, 1 / response_.yaw_rate_gain_1_s);
  const Vec2 rest_m = way_m - (then.p_m - now_.p_m);
  if (rest_m.dot(then.heading) < kPassed_m) return from_here;
  const ArcCommand from_then = arc_towards(then.heading, rest_m, speed_m_s, now_.v_m_s, limits);
  return from_then.v_m_s > 0 ? from_then : from_here;
}

std::size_t ArcLadder::top() const {
  if (leads_on()) return turn_levels() + scales_.size();
  return full_.w_rad_s != 0 ? turn_levels() : 0;
}

double ArcLadder::speed_scale(std::size_t level) const {
  if (level > turn_levels()) return scales_[level - turn_levels() - 1];
  return level > 0 && !leads_on() ? turn_scales_[level - 1] : 0;
}

ArcCommand ArcLadder::arc(std::size_t level) const {
  if (level == 0) return {};
  if (level <= turn_levels()) return {0, turn_scales_[level - 1] * turn_.w_rad_s};
  const double scale = speed_scale(level);
  return {scale * full_.v_m_s, scale * full_.w_rad_s};
}

PredictedStop ArcLadder::predict(std::size_t level, double hold_s, double sample_s,
                                 std::vector<Vec2>& track, std::vector<Vec2>* headings) const {
  const ArcCommand command = arc(level);
  response_.predict_stop(now_, before_, command, hold_s, sample_s, track, headings);
  return {command.v_m_s * now_.heading, std::max(std::abs(command.v_m_s), std::abs(now_.v_m_s)),
          response_.error_m(now_, command)};
}

double ArcLadder::speed_m_s() const { return std::abs(now_.v_m_s); }

double ArcLadder::stray_m(const VehicleState& state) const {
  return response_.error_m(response_.motion_of(state), {});
}

}  // namespace voronaut
