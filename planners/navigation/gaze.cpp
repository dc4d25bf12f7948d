#include "voronaut/planners/navigation/gaze.h"

namespace voronaut {

namespace {

constexpr double kLookAhead_m = 1.0;
constexpr double kRest_m = 0.3;

}  // namespace

Eigen::Vector2d GazePolicy::heading(const PathTracker& tracker, const Eigen::Vector2d& p_world) {
  if (gaze_ == Gaze::path && tracker.has_path()) {
    const Eigen::Vector2d ahead =
        tracker.path().point_at(tracker.station_m() + kLookAhead_m) - p_world;
    if (ahead.norm() > kRest_m) heading_ = ahead.normalized();
  }
  return heading_;
}

}  // namespace voronaut
