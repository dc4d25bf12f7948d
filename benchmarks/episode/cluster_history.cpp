#include "voronaut/benchmarks/episode/cluster_history.h"

#include <algorithm>

namespace voronaut {

void ClusterHistory::note(std::size_t scan, const ObstacleSnapshot& known) {
  std::erase_if(living_, [&](const Living& cluster) {
    const ClusterId now = known.cluster_of(cluster.member);
    if (now != cluster.id) merges_.push_back({scan, cluster.id, now});
    return now != cluster.id;
  });
  while (labels_.size() < known.points().size()) {
    const auto point = static_cast<PointId>(labels_.size());
    const ClusterId id = known.cluster_of(point);
    labels_.push_back(id);
    const auto same = [id](const Living& cluster) { return cluster.id == id; };
    if (std::none_of(living_.begin(), living_.end(), same)) living_.push_back({id, point});
  }
}

}  // namespace voronaut
