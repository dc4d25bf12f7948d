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

// Whether the body is a polygon whose heading is part of what is predicted.
bool turns_as_predicted(const MotionResponse& response, const Footprint& footprint) {
  return !footprint.is_disc() && !std::holds_alternative<VelocityResponse>(response);
}

}  // namespace

const Bounds SafetyGovernor::kEverywhere{Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                         Vec2::Constant(std::numeric_limits<double>::infinity())};

SafetyGovernor::SafetyGovernor(const MotionResponse& response, double body_radius_m,
                               double planning_clearance_m, double hold_s,
                               const Bounds& centre_bounds_world, const Footprint& footprint,
                               const DeclaredErrors& errors)
    : ladder_(ladder_of(response, turns_as_predicted(response, footprint))),
      tube_(body_radius_m, centre_bounds_world),
      sweep_(turns_as_predicted(response, footprint) ? std::optional<FootprintSweep>(footprint)
                                                     : std::nullopt),
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
  level_ = found_level(free, known, keep_m);
  allowed_.speed_scale = ladder_->speed_scale(level_);
  if (ladder_->leads_on() || (allowed_.refused_at && free.is_free(*allowed_.refused_at)))
    allowed_.refused_at.reset();
  if (ladder_->leads_on() && level_ < top && ladder_->speed_m_s() <= kDepartureSpeed_m_s) {
    allowed_.refused_at = unknown_refused(free);
  }
  allowed_.command = ladder_->command(level_);
  allowed_.v_world = level_ > 0 ? safe_stop_.v_command_world : Vec2(0, 0);
  if (level_ == 0) safe_corners_.clear();
  allowed_.tube_world = safe_corners_;
  ladder_->give(level_);
  return allowed_;
}

std::optional<Vec2> SafetyGovernor::unknown_refused(const FreeSpace& free) {
  if (sweep_) return sweep_->first_unknown(refused_stop_, refused_track_, refused_headings_, free);
  return free.first_unknown_in_tube(refused_corners_, tube_.radius_m(refused_stop_));
}

std::optional<Vec2> SafetyGovernor::way_out(const Vec2& towards, const VehicleState& state,
                                            double near_m, const FreeSpace& free,
                                            const std::optional<Vec2>& known_point) {
  const Vec2 p = state.p_world.head<2>();
  if (sweep_) {
    const double room_m = ladder_->stray_m(state) + near_m;
    return sweep_->way_out(towards, p, state.heading_world(), room_m, free);
  }
  const std::array here{p, p};
  const double tube_m = tube_.body_radius_m() + room_to_bounds_m(state);
  free.unknown_cells_in_tube(here, tube_m + near_m, touched_);
  if (known_point) touched_.push_back(*known_point);
  if (touched_.empty()) return std::nullopt;
  return departing_direction(towards, p, touched_);
}

// All that is wanted, straight or a little aside, if it was fast before; else as fast as is safe.
std::size_t SafetyGovernor::found_level(const FreeSpace& free, const ObstacleSnapshot& known,
                                        double keep_m) {
  const std::size_t top = ladder_->top();
  if (top == 0) return 0;
  if (level_ > top || ladder_->speed_scale(level_) < kFastScale)
    return safe_level(top + 1, free, known, keep_m);
  if (is_safe(top, free, known, keep_m) || goes_aside(free, known, keep_m)) return top;
  return safe_level(top, free, known, keep_m);
}

// Keeps its stop and its corners as those of the safe command, or of the refused one.
bool SafetyGovernor::is_safe(std::size_t level, const FreeSpace& free,
                             const ObstacleSnapshot& known, double keep_m) {
  const PredictedStop stop = predict(level);
  const bool safe = sweep_ ? tube_.keeps_clear(stop, corners_, known, keep_m) &&
                                 sweep_->is_safe(stop, track_, headings_, free)
                           : tube_.is_safe(stop, corners_, free, known, keep_m);
  if (!safe) {
    refused_stop_ = stop;
    refused_corners_.swap(corners_);
    refused_track_.swap(track_);
    refused_headings_.swap(headings_);
    return false;
  }
  safe_stop_ = stop;
  safe_corners_.swap(corners_);
  return true;
}

// The fastest safe level below `unsafe`. What is no disc turns on the spot at the lowest ones.
std::size_t SafetyGovernor::safe_level(std::size_t unsafe, const FreeSpace& free,
                                       const ObstacleSnapshot& known, double keep_m) {
  const std::size_t turns = sweep_ && ladder_->leads_on() ? ladder_->turn_levels() : 0;
  const std::size_t safe = safe_level_between(turns, unsafe, free, known, keep_m);
  if (safe > turns || turns == 0) return safe;
  return safe_level_between(0, turns + 1, free, known, keep_m);
}

// A slower command sweeps less, so levels are safe up to one of them, below `unsafe`; `safe` if
// none above it is. That is most often the level of the call before or next to it: looked for there
// first, then by bisection.
std::size_t SafetyGovernor::safe_level_between(std::size_t safe, std::size_t unsafe,
                                               const FreeSpace& free, const ObstacleSnapshot& known,
                                               double keep_m) {
  const std::size_t lowest = safe + 1;
  std::size_t level = std::max(lowest, std::min(level_ + 1, unsafe - 1));
  bool near = true;
  while (unsafe - safe > 1) {
    const bool is_unsafe = !is_safe(level, free, known, keep_m);
    (is_unsafe ? unsafe : safe) = level;
    if (near && is_unsafe && level > lowest)
      --level;
    else
      level = (safe + unsafe) / 2;
    near = false;
  }
  return safe;
}

// The stop that this level leads to, its track into corners_. It begins where the vehicle is told
// to be, and leads where it is told to look.
PredictedStop SafetyGovernor::predict(std::size_t level) {
  PredictedStop stop =
      sweep_ ? ladder_->predict(level, hold_s_, FootprintSweep::kSample_s, track_, &headings_)
             : ladder_->predict(level, hold_s_, kSample_s, track_);
  StopTube::straighten(track_, corners_);
  if (errors_.sensing.none() && errors_.stop_per_speed_s == 0) return stop;
  double way_m = sweep_ ? tube_.body_radius_m() : 0;  // of what a wrong heading moves aside
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
    way_m += (corners_[i + 1] - corners_[i]).norm();
  stop.stray_m += errors_.sensing.position_m + errors_.sensing.heading_rad * way_m +
                  errors_.stop_per_speed_s * stop.fastest_m_s;
  return stop;
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
