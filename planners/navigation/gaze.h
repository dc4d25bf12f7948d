#pragma once

#include <optional>

#include <Eigen/Core>

#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/navigation/path_tracker.h"

namespace voronaut {

// Where the vehicle looks: the range finder sees what lies around that direction.
class GazePolicy {
 public:
  GazePolicy(Gaze gaze, const Eigen::Vector2d& start_heading)
      : gaze_(gaze), heading_(start_heading) {}

  // Unit vector. Along the path it is a point about a metre ahead; closer than that to its end the
  // gaze rests. A vehicle that is held back for a place in doubt looks there.
  Eigen::Vector2d heading(const PathTracker& tracker, const Eigen::Vector2d& p_world,
                          const std::optional<Eigen::Vector2d>& in_doubt_world);

  // Turning rate that brings the gaze there sooner than the regulator's own yaw loop would
  // (feedforward), given where the vehicle looks now. 0 for a fixed gaze.
  double yaw_rate_rad_s(const Eigen::Vector2d& wanted_heading,
                        const Eigen::Vector2d& heading_now) const;

 private:
  Gaze gaze_;
  Eigen::Vector2d heading_;
};

}  // namespace voronaut
