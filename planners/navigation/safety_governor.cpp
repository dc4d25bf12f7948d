#include "voronaut/planners/navigation/safety_governor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "voronaut/planners/navigation/departure.h"

namespace voronaut {

namespace {

// Level 0 is braking.
constexpr std::array kSpeedScales = {0.0, 0.05, 0.12, 0.25, 0.4, 0.6, 0.8, 1.0};
constexpr std::size_t kFull = kSpeedScales.size() - 1;
constexpr double kSample_s = 0.05;
// Samples of the track may lie this far beside its straight segments; the tube is wider by it.
constexpr double kStraight_m = 0.005;
// What is too close already may stay as close as it is, up to rounding.
constexpr double kRounding_m = 1e-6;

}  // namespace

const Bounds SafetyGovernor::kEverywhere{Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                         Vec2::Constant(std::numeric_limits<double>::infinity())};

SafetyGovernor::SafetyGovernor(const VelocityResponse& response, double body_radius_m,
                               double planning_clearance_m, double hold_s,
                               const Bounds& centre_bounds_world)
    : response_(response),
      body_radius_m_(body_radius_m),
      keep_from_known_m_(planning_clearance_m - kKnownMargin_m),
      hold_s_(hold_s),
      centre_bounds_world_(centre_bounds_world) {}

double SafetyGovernor::room_to_bounds_m(const VehicleState& state) const {
  const PlanarMotion now = response_.motion_of(state);
  return response_.error_m(now, now.v_m_s) + kStraight_m;
}

const GovernedVelocity& SafetyGovernor::allow(const Vec2& v_wanted_world, const VehicleState& state,
                                              const FreeSpace& free, const ObstacleSnapshot& known,
                                              KnownClearance kept) {
  const PlanarMotion now = response_.motion_of(state);
  double keep_m = kept == KnownClearance::reduced ? 0 : keep_from_known_m_;
  if (const auto closest = known.nearest(now.p_m, keep_m)) {
    keep_m = std::max(0.0, (known.points()[*closest] - now.p_m).norm() - kRounding_m);
  }
  const bool wants_to_move = v_wanted_world.squaredNorm() > 0;
  level_ = wants_to_move ? safe_level(v_wanted_world, now, free, known, keep_m) : 0;
  allowed_.speed_scale = kSpeedScales[level_];
  allowed_.refused_at.reset();
  if (wants_to_move && level_ < kFull && now.v_m_s.norm() <= kDepartureSpeed_m_s) {
    allowed_.refused_at = free.first_unknown_in_tube(
        refused_corners_, tube_radius_m(kSpeedScales[level_ + 1], v_wanted_world, now));
  }
  allowed_.v_world = Vec2(0, 0);
  if (allowed_.speed_scale > 0)
    allowed_.v_world = command_at(allowed_.speed_scale, v_wanted_world, now);
  if (allowed_.speed_scale == 0) corners_.clear();
  allowed_.tube_world = corners_;
  v_before_ = allowed_.v_world;
  return allowed_;
}

// A slower command sweeps less, so levels are safe up to one of them. That is most often the level
// of the call before or next to it: looked for there first, then by bisection.
std::size_t SafetyGovernor::safe_level(const Vec2& v_wanted_world, const PlanarMotion& now,
                                       const FreeSpace& free, const ObstacleSnapshot& known,
                                       double keep_m) {
  std::size_t safe = 0, unsafe = kFull + 1;
  std::size_t level = std::min(level_ + 1, kFull);
  bool near = true;
  while (unsafe - safe > 1) {
    if (is_safe(kSpeedScales[level], v_wanted_world, now, free, known, keep_m)) {
      safe = level;
      safe_corners_.swap(corners_);
    } else {
      unsafe = level;
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

Vec2 SafetyGovernor::command_at(double speed_scale, const Vec2& v_wanted_world,
                                const PlanarMotion& now) const {
  return now.v_m_s + kVelocityGain * (speed_scale * v_wanted_world - now.v_m_s);
}

double SafetyGovernor::tube_radius_m(double speed_scale, const Vec2& v_wanted_world,
                                     const PlanarMotion& now) const {
  return body_radius_m_ + response_.error_m(now, speed_scale * v_wanted_world) + kStraight_m;
}

bool SafetyGovernor::is_safe(double speed_scale, const Vec2& v_wanted_world,
                             const PlanarMotion& now, const FreeSpace& free,
                             const ObstacleSnapshot& known, double keep_m) {
  const double radius_m = tube_radius_m(speed_scale, v_wanted_world, now);
  const Vec2 v_command_m_s = command_at(speed_scale, v_wanted_world, now);
  response_.predict_stop(now, v_before_, v_command_m_s, hold_s_, kSample_s, track_);
  straighten_track();
  if (!keeps_to_bounds(v_command_m_s, now, radius_m - body_radius_m_)) return false;
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
    if (!known.swept_disc_is_clear(corners_[i], corners_[i + 1], keep_m)) return false;
  }
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i) {
    if (!free.swept_disc_is_free(corners_[i], corners_[i + 1], radius_m)) {
      return departs(v_command_m_s, now, free, radius_m);
    }
  }
  return true;
}

bool SafetyGovernor::departs(const Vec2& v_command_m_s, const PlanarMotion& now,
                             const FreeSpace& free, double radius_m) {
  if (std::max(v_command_m_s.norm(), now.v_m_s.norm()) > kDepartureSpeed_m_s) return false;
  free.unknown_cells_in_tube(corners_, radius_m, unknown_cells_);
  return leads_away(v_command_m_s, corners_, unknown_cells_);
}

bool SafetyGovernor::keeps_to_bounds(const Vec2& v_command_m_s, const PlanarMotion& now,
                                     double room_m) {
  const Bounds& bounds = centre_bounds_world_;
  outside_.clear();
  for (const int axis : {0, 1}) {
    const auto [lowest, highest] =
        std::ranges::minmax(corners_, {}, [axis](const Vec2& corner) { return corner[axis]; });
    if (lowest[axis] < bounds.min[axis] + room_m) outside_.emplace_back(now.p_m - Vec2::Unit(axis));
    if (highest[axis] > bounds.max[axis] - room_m)
      outside_.emplace_back(now.p_m + Vec2::Unit(axis));
  }
  if (outside_.empty()) return true;
  return std::max(v_command_m_s.norm(), now.v_m_s.norm()) <= kDepartureSpeed_m_s &&
         leads_away(v_command_m_s, corners_, outside_);
}

// Sleeve fitting: a segment goes on as long as its end is seen from its start between both sides of
// every sample passed, each kStraight_m beside it, and lies farther than all of them.
void SafetyGovernor::straighten_track() {
  corners_.assign(1, track_.front());
  Vec2 right(0, 0), left(0, 0);  // the sleeve, as seen from the start of the segment; zero: open
  double farthest_sq = 0;
  for (std::size_t i = 1; i < track_.size(); ++i) {
    const Vec2 to = track_[i] - corners_.back();
    const double reach_sq = to.squaredNorm();
    const bool in_sleeve = reach_sq >= farthest_sq && cross(right, to) >= 0 && cross(to, left) >= 0;
    if (!in_sleeve) {
      corners_.push_back(track_[i - 1]);
      right = left = Vec2(0, 0);
      farthest_sq = 0;
      --i;
      continue;
    }
    if (reach_sq <= kStraight_m * kStraight_m) continue;
    farthest_sq = reach_sq;
    const Vec2 side = left_of(to) * (kStraight_m / std::sqrt(reach_sq));
    if (right == Vec2(0, 0) || cross(right, to - side) > 0) right = to - side;
    if (left == Vec2(0, 0) || cross(to + side, left) > 0) left = to + side;
  }
  corners_.push_back(track_.back());
}

}  // namespace voronaut
