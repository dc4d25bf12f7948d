#pragma once

#include <optional>

#include <Eigen/Core>

#include "voronaut/planners/navigation/navigation_config.h"
#include "voronaut/planners/navigation/path_tracker.h"

namespace voronaut {

// Where the vehicle looks: the range finder sees what lies around that direction.
class YawPolicy {
 public:
  YawPolicy(YawReference reference, const Eigen::Vector2d& start_heading)
      : reference_(reference), heading_(start_heading) {}

  // Unit vector. Along the path it is a point about a metre ahead; closer than that to its end the
  // heading rests. A vehicle that is held back for an unknown place looks there.
  Eigen::Vector2d heading(const PathTracker& tracker, const Eigen::Vector2d& p_world,
                          const std::optional<Eigen::Vector2d>& unknown_ahead_world);

  // Turning rate that brings the heading there sooner than the regulator's own yaw loop would
  // (feedforward), given where the vehicle looks now. 0 for a fixed heading.
  double yaw_rate_rad_s(const Eigen::Vector2d& wanted_heading,
                        const Eigen::Vector2d& heading_now) const;

 private:
  YawReference reference_;
  Eigen::Vector2d heading_;
};

}  // namespace voronaut
