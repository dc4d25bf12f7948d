#pragma once

#include <cstddef>
#include <vector>

#include "voronaut/planners/mapping/obstacle_snapshot.h"

namespace voronaut {

// How the obstacle base grouped its points over time, for replays: clusters are only ever merged,
// so the label at birth of each point and the list of merges tell every grouping there was.
class ClusterHistory {
 public:
  struct Merge {
    std::size_t scan = 0;  // index of the scan that brought it
    ClusterId from = 0;    // ceased
    ClusterId into = 0;
  };

  // After the update with scan number `scan`. O(living clusters + new points).
  void note(std::size_t scan, const ObstacleSnapshot& known);

  const std::vector<ClusterId>& labels() const { return labels_; }  // of each point when it came
  const std::vector<Merge>& merges() const { return merges_; }      // in order

 private:
  struct Living {
    ClusterId id = 0;
    PointId member = 0;
  };
  std::vector<Living> living_;
  std::vector<ClusterId> labels_;
  std::vector<Merge> merges_;
};

}  // namespace voronaut
