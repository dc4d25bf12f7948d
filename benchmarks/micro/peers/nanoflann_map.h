#pragma once

#include <utility>
#include <vector>

#include <nanoflann.hpp>

#include "voronaut/benchmarks/micro/peers/measured_scan.h"

namespace voronaut::micro {

// Euclidean clustering of a single scan by radius search in a k-d tree that is built anew; nothing
// is kept between scans.
class NanoflannClustering {
 public:
  explicit NanoflannClustering(double link_distance_m)
      : link_sq_(link_distance_m * link_distance_m) {}

  void insert(const MeasuredScan& scan) {
    const Cloud cloud{scan.returns_world};
    clusters_ = 0;
    if (cloud.points.empty()) return;
    const Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    std::vector<bool> taken(cloud.points.size());
    std::vector<std::size_t> front;
    std::vector<std::pair<std::size_t, double>> near;
    const nanoflann::SearchParams unsorted(32, 0, false);
    for (std::size_t seed = 0; seed < taken.size(); ++seed) {
      if (taken[seed]) continue;
      ++clusters_;
      taken[seed] = true;
      front.assign(1, seed);
      while (!front.empty()) {
        const Vec2& p = cloud.points[front.back()];
        front.pop_back();
        tree.radiusSearch(p.data(), link_sq_, near, unsorted);
        for (const auto& [i, distance_sq] : near) {
          if (taken[i]) continue;
          taken[i] = true;
          front.push_back(i);
        }
      }
    }
  }
  std::size_t size() const { return clusters_; }

 private:
  struct Cloud {
    const std::vector<Vec2>& points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;
    }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                   Cloud, 2, std::size_t>;

  double link_sq_;
  std::size_t clusters_ = 0;
};

}  // namespace voronaut::micro
