#include "voronaut/planners/navigation/safety_governor.h"

#include <algorithm>
#include <limits>

#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

namespace {

constexpr double kSample_s = 0.05;
// What is too close already may stay as close as it is, up to rounding.
constexpr double kRounding_m = 1e-6;

}  // namespace

const Bounds SafetyGovernor::kEverywhere{Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                         Vec2::Constant(std::numeric_limits<double>::infinity())};

SafetyGovernor::SafetyGovernor(const MotionResponse& response, double body_radius_m,
                               double planning_clearance_m, double hold_s,
                               const Bounds& centre_bounds_world, const DeclaredErrors& errors)
    : ladder_(ladder_of(response)),
      tube_(body_radius_m, centre_bounds_world),
      errors_(errors),
      keep_from_known_m_(planning_clearance_m - kKnownMargin_m),
      hold_s_(hold_s) {}

double SafetyGovernor::room_to_bounds_m(const VehicleState& state) const {
  return ladder_->stray_m(state) + StopTube::kStraight_m + errors_.sensing.position_m +
         errors_.stop_per_speed_s * state.v_world.head<2>().norm();
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
  level_ = top > 0 ? safe_level(free, known, keep_m) : 0;
  allowed_.speed_scale = ladder_->speed_scale(level_);
  if (ladder_->leads_on() || (allowed_.refused_at && free.is_free(*allowed_.refused_at)))
    allowed_.refused_at.reset();
  if (ladder_->leads_on() && level_ < top && ladder_->speed_m_s() <= kDepartureSpeed_m_s) {
    allowed_.refused_at =
        free.first_unknown_in_tube(refused_corners_, tube_.radius_m(refused_stop_));
  }
  allowed_.command = ladder_->command(level_);
  allowed_.v_world = level_ > 0 ? safe_stop_.v_command_world : Vec2(0, 0);
  if (level_ == 0) corners_.clear();
  allowed_.tube_world = corners_;
  ladder_->give(level_);
  return allowed_;
}

// The stop that this level leads to, its track into corners_. It begins where the vehicle is told
// to be, and leads where it is told to look.
PredictedStop SafetyGovernor::predict(std::size_t level) {
  PredictedStop stop = ladder_->predict(level, hold_s_, kSample_s, track_);
  StopTube::straighten(track_, corners_);
  double way_m = 0;
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
    way_m += (corners_[i + 1] - corners_[i]).norm();
  stop.stray_m += errors_.sensing.position_m + errors_.sensing.heading_rad * way_m +
                  errors_.stop_per_speed_s * stop.fastest_m_s;
  return stop;
}

// A slower command sweeps less, so levels are safe up to one of them. That is most often the level
// of the call before or next to it: looked for there first, then by bisection.
std::size_t SafetyGovernor::safe_level(const FreeSpace& free, const ObstacleSnapshot& known,
                                       double keep_m) {
  const std::size_t top = ladder_->top();
  std::size_t safe = 0, unsafe = top + 1;
  std::size_t level = std::min(level_ + 1, top);
  bool near = true;
  while (unsafe - safe > 1) {
    const PredictedStop stop = predict(level);
    if (tube_.is_safe(stop, corners_, free, known, keep_m)) {
      safe = level;
      safe_stop_ = stop;
      safe_corners_.swap(corners_);
    } else {
      unsafe = level;
      refused_stop_ = stop;
      refused_corners_.swap(corners_);
    }
    if (near && unsafe == level && level > 1)
      --level;
    else
      level = (safe + unsafe) / 2;
    near = false;
  }
  corners_.swap(safe_corners_);
  return safe;
}

}  // namespace voronaut
