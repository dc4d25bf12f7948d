#pragma once

#include <cstddef>
#include <cstdint>

#include "voronaut/environments/sensing/ray_caster.h"
#include "voronaut/environments/sensing/scan.h"
#include "voronaut/environments/shapes/shape_index.h"

namespace voronaut::micro {

// The workload of docs/performance.md: a vehicle on the curve y = 3 m sin(x / 8 m) through random
// circles of radius 0.3 to 1.0 m in a corridor of 24 m; circles within 0.6 m of the curve are left
// out. Exact ranges, one scan per step_m along the curve.
struct ForestWalkConfig {
  double density_per_m2 = 0.1;
  std::size_t rays = 181;
  double field_of_view_deg = 90;
  double max_range_m = 5;
  double step_m = 0.2;       // 2 m/s at 10 Hz; 0.02 for 100 Hz
  std::size_t scans = 1000;  // how far the forest must reach
  std::uint64_t seed = 1;
  bool walls = false;  // instead of each circle one of its diameters, across the way
  double aside_m = 0;  // every scan is reported this far to the left (y) of where it was taken
};

class ForestWalk {
 public:
  explicit ForestWalk(const ForestWalkConfig& config);

  // Moves on by one step and measures; the scan is valid until the next call.
  const Scan& next();

  std::size_t circles() const { return forest_.circles().size(); }
  const ShapeIndex& forest() const { return forest_; }

 private:
  ForestWalkConfig config_;
  ShapeIndex forest_;
  double x_m_ = 0;
  Scan scan_;
};

}  // namespace voronaut::micro
