#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/stages/cluster_base.h"
#include "voronaut/planners/mapping/stages/scan_clusterer.h"
#include "voronaut/planners/mapping/stages/scan_returns.h"

namespace voronaut {

// From here on returns of a scan are represented by this stored point, or others of its label.
struct Representative {
  std::uint32_t from_beam = 0;
  PointId point = 0;
  bool stored_now = false;
};

// Stage 3 of the papers: which clusters of a scan have stored points in common with known clusters,
// or with each other, and which points are new. The storage is used again for every scan.
class ScanJoining {
 public:
  // The representatives are in the order of their beams, the first one is that of the first return.
  // Points from first_new on were stored in this scan, in that order. O(runs + representatives).
  void join(const ScanReturns& returns, const ScanClusterer& clusterer,
            std::span<const Representative> representatives, PointId first_new,
            const ClusterBase& known);

  // Pairs of known clusters with a cluster of the scan in common, for whoever merges them.
  std::vector<ClusterBase::Pair>& bridged() { return bridged_; }
  // When they are merged: the new points in the order of their bearing, in new clusters where no
  // known one was met.
  void append_new_points(ClusterBase& clusters, std::span<const Vec2> points);
  // After that: the cluster, living or not, that a cluster of the scan became part of.
  ClusterId cluster_of(std::size_t scan_cluster) const {
    return joined_[joined_[scan_cluster].to].known;
  }

 private:
  struct Joined {
    std::uint32_t to = 0;  // an earlier cluster of the scan, or itself
    ClusterId known = 0;   // the first known one it meets
  };
  struct NewPoint {
    PointId point = 0;
    std::uint32_t scan_cluster = 0;
    std::uint32_t rank = 0;  // in the order of bearing
  };

  void make_room(std::size_t beams);
  void join(std::uint32_t scan_cluster, PointId point, PointId first_new, const ClusterBase& known);
  void meet(std::uint32_t scan_cluster, ClusterId known);

  std::vector<Joined> joined_;  // of the first cluster_count_
  std::size_t cluster_count_ = 0;
  std::vector<NewPoint> new_points_;  // the first new_point_count_ are in use
  std::size_t new_point_count_ = 0;
  std::vector<ClusterBase::Pair> bridged_;
};

}  // namespace voronaut
