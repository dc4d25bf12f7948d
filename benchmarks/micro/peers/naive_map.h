#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "voronaut/benchmarks/micro/peers/measured_scan.h"

namespace voronaut::micro {

// What the papers argue against: every return is compared with all stored coordinates, to drop it
// if it is known and else to link it to the clusters near it.
class NaiveMap {
 public:
  NaiveMap(double thinning_distance_m, double link_distance_m)
      : thinning_sq_(thinning_distance_m * thinning_distance_m),
        link_sq_(link_distance_m * link_distance_m) {}

  void insert(const MeasuredScan& scan) {
    for (const Vec2& p : scan.returns_world) insert(p);
  }
  std::size_t size() const { return points_.size(); }

 private:
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void insert(const Vec2& p) {
    near_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double distance_sq = (points_[i] - p).squaredNorm();
      if (distance_sq < thinning_sq_) return;
      if (distance_sq < link_sq_) near_.push_back(i);
    }
    const std::size_t added = points_.size();
    points_.push_back(p);
    parent_.push_back(added);
    for (const std::size_t i : near_) parent_[root(i)] = root(added);
  }

  double thinning_sq_;
  double link_sq_;
  std::vector<Vec2> points_;
  std::vector<std::size_t> parent_;
  std::vector<std::size_t> near_;
};

}  // namespace voronaut::micro
