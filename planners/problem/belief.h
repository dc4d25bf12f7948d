#pragma once

#include <span>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {

// Everything a planner may know at one moment. Views: valid until the next scan arrives.
struct Belief {
  ObstacleSnapshot obstacles;
  const Scan* scan = nullptr;                  // the latest; null before the first
  std::span<const ScanCluster> scan_clusters;  // of that scan
  Pose2 pose_world;                            // of the vehicle, exact
};

}  // namespace voronaut
