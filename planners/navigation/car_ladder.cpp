#include "voronaut/planners/navigation/car_ladder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voronaut {

namespace {

// Level 0 is braking.
constexpr std::array kCarScales = {0.0, 0.05, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0};
constexpr double kBackUp_m_s = 0.6;
constexpr double kStands_m_s = 0.05;
// Slower than this the governor as good as holds it back.
constexpr double kHeldBackBelow = 0.2;
// Of a turning radius: shorter parts of a turn than this end only where the way does.
constexpr double kLeastPart = 0.5;
// It goes ahead again with the point this well ahead of it (37 deg).
constexpr double kAheadCosine = 0.8;
constexpr double kRoomInCircle = 0.98;

// Whether no arc leads there: nearer than the turning circle on its side.
bool within_circle(const CarMotion& now, const Vec2& way_m, double radius_m) {
  const double left_m = now.heading.x() * way_m.y() - now.heading.y() * way_m.x();
  const Vec2 centre_m = std::copysign(radius_m, left_m) * left_of(now.heading);
  return (way_m - centre_m).norm() < kRoomInCircle * radius_m;
}

}  // namespace

void CarLadder::set_up(const WantedMotion& wanted, const VehicleState& state) {
  now_ = response_.motion_of(state);
  const double speed_m_s = wanted.v_world.norm();
  full_ = {};
  if (speed_m_s == 0) return;
  const Vec2 way_m = (wanted.lookahead_m / speed_m_s) * wanted.v_world;
  if (wanted.may_reverse && now_.heading.dot(way_m) < 0) {
    CarMotion turned_round = now_;
    turned_round.heading = -now_.heading;
    const ArcCommand ahead = steered_towards(turned_round, way_m, speed_m_s, response_);
    full_ = {-ahead.v_m_s, ahead.w_rad_s};
    return;
  }
  full_ = backs_up(way_m) ? back_up(way_m, std::min(speed_m_s, kBackUp_m_s))
                          : steered_towards(now_, way_m, speed_m_s, response_);
}

bool CarLadder::backs_up(const Vec2& way_m) {
  const double radius_m = response_.turning_radius_m();
  const bool within = within_circle(now_, way_m, radius_m);
  const bool stuck = held_back_ && std::abs(now_.v_m_s) < kStands_m_s;
  const double driven_m = (now_.p_m - changed_at_).norm();
  const bool ahead = now_.heading.dot(way_m) > kAheadCosine * way_m.norm();
  const bool far_enough = driven_m > kLeastPart * radius_m;
  const bool change = stuck || (backing_ ? driven_m > radius_m || (ahead && !within && far_enough)
                                         : within && far_enough);
  if (change) {
    backing_ = !backing_;
    changed_at_ = now_.p_m;
    held_back_ = false;
  }
  return backing_;
}

ArcCommand CarLadder::back_up(const Vec2& way_m, double speed_m_s) const {
  const ArcCommand ahead = steered_towards(now_, way_m, speed_m_s, response_);
  return {-ahead.v_m_s, ahead.w_rad_s};
}

std::size_t CarLadder::top() const { return full_.v_m_s != 0 ? kCarScales.size() - 1 : 0; }

double CarLadder::speed_scale(std::size_t level) const { return kCarScales[level]; }

ArcCommand CarLadder::arc(std::size_t level) const {
  return {kCarScales[level] * full_.v_m_s, kCarScales[level] * full_.w_rad_s};
}

PredictedStop CarLadder::predict(std::size_t level, double hold_s, double sample_s,
                                 std::vector<Vec2>& track, std::vector<Vec2>* headings) const {
  const ArcCommand command = arc(level);
  response_.predict_stop(now_, before_, command, hold_s, sample_s, track, headings);
  return {command.v_m_s * now_.heading, std::max(std::abs(command.v_m_s), std::abs(now_.v_m_s)),
          response_.error_m(now_, command)};
}

void CarLadder::give(std::size_t level) {
  before_ = arc(level);
  held_back_ = top() > 0 && kCarScales[level] < kHeldBackBelow;
}

double CarLadder::speed_m_s() const { return std::abs(now_.v_m_s); }

double CarLadder::stray_m(const VehicleState& state) const {
  return response_.error_m(response_.motion_of(state), {});
}

}  // namespace voronaut
