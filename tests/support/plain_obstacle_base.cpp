#include "voronaut/tests/support/plain_obstacle_base.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "voronaut/planners/mapping/points/convex_polygon.h"

namespace voronaut {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

// Labels 0..n-1 of the connected components, in the order of their first elements.
template <class Related>
std::vector<std::size_t> components(std::size_t n, const Related& related) {
  std::vector<std::size_t> label(n);
  std::iota(label.begin(), label.end(), std::size_t{0});
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (label[i] == label[j] || !related(i, j)) continue;
      const auto [low, high] = std::minmax(label[i], label[j]);
      std::replace(label.begin(), label.end(), std::size_t{high}, std::size_t{low});
    }
  }
  return label;
}

}  // namespace

std::size_t PlainObstacleBase::represent(const Vec2& p, std::size_t previous) {
  const double thinning_sq = config_.thinning_distance_m * config_.thinning_distance_m;
  const auto known_by = [&](std::size_t i) { return (points_[i] - p).squaredNorm() < thinning_sq; };
  if (previous != kNone && known_by(previous)) return previous;
  const auto next = came_next_.find(previous);
  if (next != came_next_.end() && known_by(next->second)) return next->second;
  std::size_t nearest = kNone;
  double nearest_sq = thinning_sq;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double distance_sq = (points_[i] - p).squaredNorm();
    if (distance_sq < nearest_sq) {
      nearest = i;
      nearest_sq = distance_sq;
    }
  }
  if (nearest == kNone) {
    nearest = points_.size();
    points_.push_back(p);
  }
  return came_next_[previous] = nearest;
}

void PlainObstacleBase::absorb(ClusterId into, ClusterId from) {
  Cluster& a = clusters_[into];
  Cluster& b = clusters_[from];
  for (const PointId id : b.members) label_[id] = into;
  a.members.insert(a.members.end(), b.members.begin(), b.members.end());
  a.hull.insert(a.hull.end(), b.hull.begin(), b.hull.end());
  reduce_to_convex_hull(a.hull);
  b = {};
  ++report_.merges;
}

bool PlainObstacleBase::related(const Cluster& a, const Cluster& b) {
  ++report_.pairs_tested;
  if (convex_polygons_touch(a.hull, b.hull)) return true;
  const double merge_sq = config_.merge_distance_m * config_.merge_distance_m;
  for (const PointId i : {a.members.front(), a.members.back()}) {
    for (const PointId j : {b.members.front(), b.members.back()}) {
      if ((points_[i] - points_[j]).squaredNorm() < merge_sq) return true;
    }
  }
  return false;
}

bool PlainObstacleBase::merge_round() {
  std::vector<ClusterId> living;
  for (ClusterId id = 0; id < clusters_.size(); ++id) {
    if (!clusters_[id].members.empty()) living.push_back(id);
  }
  const auto label = components(living.size(), [&](std::size_t i, std::size_t j) {
    return related(clusters_[living[i]], clusters_[living[j]]);
  });
  bool merged = false;
  for (std::size_t i = 0; i < living.size(); ++i) {
    if (label[i] == i) continue;
    absorb(living[label[i]], living[i]);
    merged = true;
  }
  return merged;
}

const UpdateReport& PlainObstacleBase::update(const Scan& scan) {
  report_ = {};
  scan_clusters_.clear();
  listed_world_.clear();
  const double listing_m = std::min(config_.thinning_distance_m, config_.link_distance_m / 2);
  const double link_sq = config_.link_distance_m * config_.link_distance_m;

  // Returns, what represents them, and which of them a scan cluster lists.
  std::vector<Vec2> returned;
  std::vector<std::size_t> beam;
  std::vector<std::size_t> representative;
  std::vector<bool> stored;
  std::vector<bool> listed;
  std::size_t first_measured = kNone;
  std::size_t last_measured = kNone;
  const std::size_t known_before = points_.size();
  Vec2 last_listed = Vec2::Zero();
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const double range_m = scan.range_m[i];
    if (!(range_m > 0 && range_m <= scan.max_range_m)) {
      ++report_.invalid;
      continue;
    }
    if (first_measured == kNone) first_measured = i;
    last_measured = i;
    if (!scan.is_return(i)) continue;
    const Vec2 p = scan.point_world(i);
    const std::size_t known_points = points_.size();
    representative.push_back(represent(p, representative.empty() ? kNone : representative.back()));
    stored.push_back(points_.size() > known_points);
    listed.push_back(returned.empty() ||
                     !((p - last_listed).squaredNorm() < listing_m * listing_m));
    if (listed.back()) last_listed = p;
    returned.push_back(p);
    beam.push_back(i);
  }
  report_.returns = returned.size();
  report_.points_added = points_.size() - known_before;

  const auto scan_label = components(returned.size(), [&](std::size_t i, std::size_t j) {
    return (returned[i] - returned[j]).squaredNorm() < link_sq;
  });
  // The scan's clusters: returns in the order of their bearing.
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> group_of(returned.size());
  for (std::size_t i = 0; i < returned.size(); ++i) {
    if (scan_label[i] == i) {
      group_of[i] = groups.size();
      groups.emplace_back();
    }
    group_of[i] = group_of[scan_label[i]];
    groups[group_of[i]].push_back(i);
  }
  const bool full_circle = scan.beams->full_circle();
  for (auto& group : groups) {
    if (full_circle) {
      std::size_t begin = 0;
      std::size_t widest = beam[group.front()] + scan.size() - beam[group.back()];
      for (std::size_t k = 1; k < group.size(); ++k) {
        const std::size_t gap = beam[group[k]] - beam[group[k - 1]];
        if (gap > widest) {
          widest = gap;
          begin = k;
        }
      }
      std::rotate(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(begin), group.end());
    }
    ScanCluster& cluster = scan_clusters_.emplace_back();
    cluster.cut_right = !full_circle && beam[group.front()] == first_measured;
    cluster.cut_left = !full_circle && beam[group.back()] == last_measured;
    std::vector<Vec2>& listed_world = listed_world_.emplace_back();
    for (const std::size_t i : group) {
      if (listed[i]) listed_world.push_back(returned[i]);
    }
  }
  report_.clusters_in_scan = groups.size();

  // Known clusters and the scan's clusters that have a stored point in common are one.
  const std::size_t known = clusters_.size();
  std::vector<std::vector<std::size_t>> touched(groups.size());  // representatives
  for (std::size_t i = 0; i < returned.size(); ++i) {
    touched[group_of[i]].push_back(representative[i]);
  }
  const auto joined = components(known + groups.size(), [&](std::size_t i, std::size_t j) {
    if (j < known) return false;
    for (const std::size_t p : touched[j - known]) {
      if (i < known && p < known_before && label_[p] == i) return true;
      if (i >= known && std::count(touched[i - known].begin(), touched[i - known].end(), p) > 0) {
        return true;
      }
    }
    return false;
  });
  label_.resize(points_.size());
  std::vector<ClusterId> cluster_of_component(joined.size());
  for (std::size_t i = 0; i < joined.size(); ++i) {
    const std::size_t root = joined[i];
    if (i < known) {
      cluster_of_component[i] = static_cast<ClusterId>(i);
      if (root != i) absorb(static_cast<ClusterId>(root), static_cast<ClusterId>(i));
      continue;
    }
    if (root == i) {
      cluster_of_component[i] = static_cast<ClusterId>(clusters_.size());
      clusters_.emplace_back();
    }
    const ClusterId id = cluster_of_component[root];
    Cluster& cluster = clusters_[id];
    for (const std::size_t k : groups[i - known]) {
      if (!stored[k]) continue;
      const std::size_t p = representative[k];
      label_[p] = id;
      cluster.members.push_back(static_cast<PointId>(p));
      cluster.hull.push_back(points_[p]);
    }
    reduce_to_convex_hull(cluster.hull);
    scan_clusters_[i - known].cluster = id;
  }
  const bool news = report_.points_added > 0 || report_.merges > 0;
  while (news && merge_round()) {
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    scan_clusters_[i].cluster = label_[representative[groups[i].front()]];
    scan_clusters_[i].points_world = listed_world_[i];
  }
  return report_;
}

}  // namespace voronaut
