#include "voronaut/planners/navigation/safety_governor.h"

#include <algorithm>
#include <array>
#include <limits>

#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

namespace {

constexpr double kSample_s = 0.05;
// What is too close already may stay as close as it is, up to rounding.
constexpr double kRounding_m = 1e-6;
// Cosine and sine of how far a course is turned aside: 0.2 and 0.4 rad.
const std::array kAside = {Vec2(0.9800665778412416, 0.19866933079506122),
                           Vec2(0.9210609940028851, 0.3894183423086505)};
// Of the speed wanted: only who is faster goes aside. Who creeps through a gap gains nothing by it.
constexpr double kFastScale = 0.4;

}  // namespace

const Bounds SafetyGovernor::kEverywhere{Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                         Vec2::Constant(std::numeric_limits<double>::infinity())};

SafetyGovernor::SafetyGovernor(const MotionResponse& response, double body_radius_m,
                               double planning_clearance_m, double hold_s,
                               const Bounds& centre_bounds_world)
    : ladder_(ladder_of(response)),
      tube_(body_radius_m, centre_bounds_world),
      keep_from_known_m_(planning_clearance_m - kKnownMargin_m),
      hold_s_(hold_s) {}

double SafetyGovernor::room_to_bounds_m(const VehicleState& state) const {
  return ladder_->stray_m(state) + StopTube::kStraight_m;
}

const GovernedMotion& SafetyGovernor::allow(const WantedMotion& wanted, const VehicleState& state,
                                            const FreeSpace& free, const ObstacleSnapshot& known,
                                            KnownClearance kept) {
  ladder_->set_up(wanted, state);
  const Vec2 p = ladder_->p_world();
  double keep_m = kept == KnownClearance::reduced ? 0 : keep_from_known_m_;
  if (const auto closest = known.nearest(p, keep_m)) {
    keep_m = std::max(0.0, (known.points()[*closest] - p).norm() - kRounding_m);
  }
  const std::size_t top = ladder_->top();
  level_ = found_level(free, known, keep_m);
  allowed_.speed_scale = ladder_->speed_scale(level_);
  if (ladder_->leads_on() || (allowed_.refused_at && free.is_free(*allowed_.refused_at)))
    allowed_.refused_at.reset();
  if (ladder_->leads_on() && level_ < top && ladder_->speed_m_s() <= kDepartureSpeed_m_s) {
    allowed_.refused_at =
        free.first_unknown_in_tube(refused_corners_, tube_.radius_m(refused_stop_));
  }
  allowed_.command = ladder_->command(level_);
  allowed_.v_world = level_ > 0 ? safe_stop_.v_command_world : Vec2(0, 0);
  if (level_ == 0) safe_corners_.clear();
  allowed_.tube_world = safe_corners_;
  ladder_->give(level_);
  return allowed_;
}

// All that is wanted, straight or a little aside, if it was fast before; else as fast as is safe.
std::size_t SafetyGovernor::found_level(const FreeSpace& free, const ObstacleSnapshot& known,
                                        double keep_m) {
  const std::size_t top = ladder_->top();
  if (top == 0 || level_ > top || ladder_->speed_scale(level_) < kFastScale)
    return safe_level(top + 1, free, known, keep_m);
  if (is_safe(top, free, known, keep_m) || goes_aside(free, known, keep_m)) return top;
  return safe_level(top, free, known, keep_m);
}

// Keeps its stop and its corners as those of the safe command, or of the refused one.
bool SafetyGovernor::is_safe(std::size_t level, const FreeSpace& free,
                             const ObstacleSnapshot& known, double keep_m) {
  const PredictedStop stop = ladder_->predict(level, hold_s_, kSample_s, track_);
  StopTube::straighten(track_, corners_);
  if (!tube_.is_safe(stop, corners_, free, known, keep_m)) {
    refused_stop_ = stop;
    refused_corners_.swap(corners_);
    return false;
  }
  safe_stop_ = stop;
  safe_corners_.swap(corners_);
  return true;
}

// A slower command sweeps less, so levels are safe up to one of them, below `unsafe`. That is most
// often the level of the call before or next to it: looked for there first, then by bisection.
std::size_t SafetyGovernor::safe_level(std::size_t unsafe, const FreeSpace& free,
                                       const ObstacleSnapshot& known, double keep_m) {
  std::size_t safe = 0;
  std::size_t level = std::min(level_ + 1, unsafe - 1);
  bool near = true;
  while (unsafe - safe > 1) {
    const bool is_unsafe = !is_safe(level, free, known, keep_m);
    (is_unsafe ? unsafe : safe) = level;
    if (near && is_unsafe && level > 1)
      --level;
    else
      level = (safe + unsafe) / 2;
    near = false;
  }
  return safe;
}

// A tube that leads past a tree touches it with a few centimetres of its width: a little aside
// there is room for all the speed that is wanted. First to the side to which it last went.
bool SafetyGovernor::goes_aside(const FreeSpace& free, const ObstacleSnapshot& known,
                                double keep_m) {
  if (!ladder_->turns_aside()) return false;
  const PredictedStop straight_stop = refused_stop_;
  straight_corners_.swap(refused_corners_);
  for (const Vec2& turn : kAside) {
    for (const bool left : {goes_left_, !goes_left_}) {
      ladder_->turn_aside(left ? turn : Vec2(turn.x(), -turn.y()));
      if (!is_safe(ladder_->top(), free, known, keep_m)) continue;
      goes_left_ = left;
      return true;
    }
  }
  ladder_->turn_aside(Vec2(1, 0));
  refused_stop_ = straight_stop;
  straight_corners_.swap(refused_corners_);
  return false;
}

}  // namespace voronaut
