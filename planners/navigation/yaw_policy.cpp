#include "voronaut/planners/navigation/yaw_policy.h"

#include "voronaut/dynamics/heading.h"

namespace voronaut {

namespace {

constexpr double kLookahead_m = 1.0;
constexpr double kRest_m = 0.3;
// Added to the yaw loops of the regulators (0.8 and 2 per second); the quadrotor's stays damped.
constexpr double kTurn_1_s = 1.2;

}  // namespace

Eigen::Vector2d YawPolicy::heading(const PathTracker& tracker, const Eigen::Vector2d& p_world,
                                   const std::optional<Eigen::Vector2d>& unknown_ahead_world) {
  if (reference_ == YawReference::path && tracker.has_path()) {
    const Eigen::Vector2d ahead =
        tracker.path().point_at(tracker.station_m() + kLookahead_m) - p_world;
    if (unknown_ahead_world && *unknown_ahead_world != p_world) {
      heading_ = (*unknown_ahead_world - p_world).normalized();
    } else if (ahead.norm() > kRest_m) {
      heading_ = ahead.normalized();
    }
  }
  return heading_;
}

double YawPolicy::yaw_rate_rad_s(const Eigen::Vector2d& wanted_heading,
                                 const Eigen::Vector2d& heading_now) const {
  if (reference_ == YawReference::fixed) return 0;
  return kTurn_1_s * heading_error_rad(heading_now, wanted_heading);
}

}  // namespace voronaut
