#pragma once

#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut::micro {

// A scan with what peers want ready in memory, so that no conversion is timed for them.
struct MeasuredScan {
  Scan scan;
  std::vector<Vec2> returns_world;
};

inline MeasuredScan measured(const Scan& scan) {
  MeasuredScan result{scan, {}};
  for (std::size_t i = 0; i < scan.size(); ++i) {
    if (scan.is_return(i)) result.returns_world.push_back(scan.point_world(i));
  }
  return result;
}

}  // namespace voronaut::micro
