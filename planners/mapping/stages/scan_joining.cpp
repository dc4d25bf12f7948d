#include "voronaut/planners/mapping/stages/scan_joining.h"

#include <algorithm>
#include <tuple>

namespace voronaut {
// A scan has no more clusters and new points than beams.
void ScanJoining::make_room(std::size_t beams) {
  joined_.resize(beams);
  new_points_.resize(beams);
}

void ScanJoining::join(const ScanReturns& returns, const ScanClusterer& clusterer,
                       std::span<const Representative> representatives, PointId first_new,
                       const ClusterBase& known) {
  if (returns.beams() > joined_.size()) make_room(returns.beams());
  cluster_count_ = clusterer.clusters().size();
  new_point_count_ = 0;
  for (std::uint32_t i = 0; i < cluster_count_; ++i) joined_[i] = {i, kNoCluster};

  const Representative* next = representatives.data();
  const Representative* const end = next + representatives.size();
  const std::span<const ScanReturns::Run> runs = returns.runs();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::uint32_t cluster = clusterer.cluster_of_run(r);
    // A run may begin with the representative of the run before it.
    if (next == end || next->from_beam != runs[r].begin) {
      join(cluster, next[-1].point, first_new, known);
    }
    for (; next != end && next->from_beam < runs[r].end; ++next) {
      if (!next->stored_now) {
        join(cluster, next->point, first_new, known);
        continue;
      }
      // Returns before the one with which a cluster begins come after its last one.
      const bool after_last = next->from_beam < clusterer.first_return(cluster);
      new_points_[new_point_count_++] = {next->point, cluster,
                                         next->from_beam + (after_last ? returns.beams() : 0)};
    }
  }
}

void ScanJoining::join(std::uint32_t scan_cluster, PointId point, PointId first_new,
                       const ClusterBase& known) {
  const auto root = [this](std::uint32_t i) {
    while (joined_[i].to != i) i = joined_[i].to;
    return i;
  };
  const std::uint32_t a = root(scan_cluster);
  if (point < first_new) {
    meet(a, known.cluster_of(point));
    return;
  }
  const std::uint32_t b = root(new_points_[point - first_new].scan_cluster);
  if (a == b) return;
  joined_[std::max(a, b)].to = std::min(a, b);
  meet(std::min(a, b), joined_[std::max(a, b)].known);
}

void ScanJoining::meet(std::uint32_t scan_cluster, ClusterId known) {
  ClusterId& first_met = joined_[scan_cluster].known;
  if (known == kNoCluster || known == first_met) return;
  if (first_met == kNoCluster) {
    first_met = known;
  } else {
    bridged_.push_back({first_met, known});
  }
}

void ScanJoining::append_new_points(ClusterBase& clusters, std::span<const Vec2> points) {
  for (std::uint32_t i = 0; i < cluster_count_; ++i) {
    // Earlier ones are resolved already.
    joined_[i].to = joined_[joined_[i].to].to;
    if (joined_[i].to == i && joined_[i].known == kNoCluster) joined_[i].known = clusters.create();
  }
  if (new_point_count_ == 0) return;
  const auto by_bearing = [](const NewPoint& a, const NewPoint& b) {
    return std::tie(a.scan_cluster, a.rank) < std::tie(b.scan_cluster, b.rank);
  };
  const std::span<NewPoint> new_points{new_points_.data(), new_point_count_};
  if (!std::ranges::is_sorted(new_points, by_bearing)) std::ranges::sort(new_points, by_bearing);
  clusters.make_room(points.size());
  for (const NewPoint& added : new_points) {
    clusters.append(clusters.living_id(cluster_of(added.scan_cluster)), added.point,
                    points[added.point]);
  }
}

}  // namespace voronaut
