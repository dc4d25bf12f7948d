#pragma once

#include <memory>
#include <vector>

#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut::test {

// A base that knows exactly these points (closer ones than 1 mm are thinned), each shown by a scan
// of one beam along +x, so each begins as a cluster of its own.
inline std::unique_ptr<ObstacleBase> base_of(const std::vector<Vec2>& points,
                                             double merge_distance_m = 0) {
  ObstacleBaseConfig config;
  config.thinning_distance_m = 0.001;
  config.merge_distance_m = merge_distance_m;
  auto base = std::make_unique<ObstacleBase>(config);
  Scan scan;
  scan.beams = std::make_shared<BeamFan>(BeamFan::spread(0, 1));
  scan.max_range_m = 2;
  scan.range_m = {1};
  for (const Vec2& p : points) {
    scan.sensor_world.p_world = p - Vec2(1, 0);
    base->update(scan);
  }
  return base;
}

}  // namespace voronaut::test
