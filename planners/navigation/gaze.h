#pragma once

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
  // gaze rests.
  Eigen::Vector2d heading(const PathTracker& tracker, const Eigen::Vector2d& p_world);

 private:
  Gaze gaze_;
  Eigen::Vector2d heading_;
};

}  // namespace voronaut
