#include "voronaut/planners/navigation/gaze.h"

#include "voronaut/dynamics/heading.h"

namespace voronaut {

namespace {

constexpr double kLookAhead_m = 1.0;
constexpr double kRest_m = 0.3;
// Added to the yaw loops of the regulators (0.8 and 2 per second); the quadrotor's stays damped.
constexpr double kTurn_1_s = 1.2;

}  // namespace

Eigen::Vector2d GazePolicy::heading(const PathTracker& tracker, const Eigen::Vector2d& p_world,
                                    const std::optional<Eigen::Vector2d>& in_doubt_world) {
  if (gaze_ == Gaze::path && tracker.has_path()) {
    const Eigen::Vector2d ahead =
        tracker.path().point_at(tracker.station_m() + kLookAhead_m) - p_world;
    if (in_doubt_world && *in_doubt_world != p_world) {
      heading_ = (*in_doubt_world - p_world).normalized();
    } else if (ahead.norm() > kRest_m) {
      heading_ = ahead.normalized();
    }
  }
  return heading_;
}

double GazePolicy::yaw_rate_rad_s(const Eigen::Vector2d& wanted_heading,
                                  const Eigen::Vector2d& heading_now) const {
  if (gaze_ == Gaze::fixed) return 0;
  return kTurn_1_s * heading_error_rad(heading_now, wanted_heading);
}

}  // namespace voronaut
