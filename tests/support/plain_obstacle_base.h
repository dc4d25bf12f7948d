#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "voronaut/planners/mapping/obstacle_base.h"

namespace voronaut {

// The papers' four stages as ObstacleBase defines them, by full search over everything: slow, and
// obviously right. ObstacleBase must agree with it in every detail but pairs_tested.
class PlainObstacleBase {
 public:
  struct Cluster {
    std::vector<PointId> members;  // in stored order; empty once merged into another
    std::vector<Vec2> hull;
  };

  explicit PlainObstacleBase(const ObstacleBaseConfig& config) : config_(config) {}

  const UpdateReport& update(const Scan& scan);

  const std::vector<ScanCluster>& scan_clusters() const { return scan_clusters_; }
  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<ClusterId>& labels() const { return label_; }
  const std::vector<Cluster>& clusters() const { return clusters_; }

 private:
  std::size_t represent(const Vec2& p, std::size_t previous);
  bool related(const Cluster& a, const Cluster& b);
  bool merge_round();
  void absorb(ClusterId into, ClusterId from);

  ObstacleBaseConfig config_;
  UpdateReport report_;
  std::vector<ScanCluster> scan_clusters_;
  std::vector<std::vector<Vec2>> listed_world_;
  std::vector<Vec2> points_;
  std::vector<ClusterId> label_;                  // of each point
  std::map<std::size_t, std::size_t> came_next_;  // after which point which one last did
  std::vector<Cluster> clusters_;
};

}  // namespace voronaut
