#pragma once

#include <octomap/octomap.h>

#include "voronaut/benchmarks/micro/peers/measured_scan.h"

namespace voronaut::micro {

// OctoMap at 0.1 m. With `carve` every beam to a return clears the cells before it; without, only
// the returns' cells are raised.
class OctomapMap {
 public:
  explicit OctomapMap(bool carve) : carve_(carve), tree_(0.1) {}

  void insert(const MeasuredScan& scan) {
    const auto point = [](const Vec2& p) {
      return octomap::point3d(static_cast<float>(p.x()), static_cast<float>(p.y()), 0);
    };
    if (!carve_) {
      for (const Vec2& p : scan.returns_world) tree_.updateNode(point(p), true, true);
      return;
    }
    octomap::Pointcloud cloud;
    for (const Vec2& p : scan.returns_world) cloud.push_back(point(p));
    tree_.insertPointCloud(cloud, point(scan.scan.sensor_world.p_world), -1, true, true);
  }
  std::size_t size() const { return tree_.size(); }

 private:
  bool carve_;
  octomap::OcTree tree_;
};

}  // namespace voronaut::micro
