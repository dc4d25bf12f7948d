#include "voronaut/planners/mapping/obstacle_base.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "voronaut/planners/mapping/convex_polygon.h"

namespace voronaut {
namespace {

constexpr ClusterId kNoCluster = 0xffff'ffff;

void check(bool allowed, const char* name, double value, const char* bound) {
  if (allowed) return;
  throw std::invalid_argument("ObstacleBaseConfig: " + std::string(name) + " is " +
                              std::to_string(value) + ", allowed is a finite number " + bound);
}

const ObstacleBaseConfig& checked(const ObstacleBaseConfig& config) {
  const auto finite = [](double v) { return std::isfinite(v); };
  check(finite(config.link_distance_m) && config.link_distance_m > 0, "link_distance_m",
        config.link_distance_m, "> 0");
  check(finite(config.thinning_distance_m) && config.thinning_distance_m > 0, "thinning_distance_m",
        config.thinning_distance_m, "> 0");
  check(finite(config.merge_distance_m) && config.merge_distance_m >= 0, "merge_distance_m",
        config.merge_distance_m, ">= 0");
  return config;
}

}  // namespace

ObstacleBase::ObstacleBase(const ObstacleBaseConfig& config)
    : config_(checked(config)),
      clusterer_(config.link_distance_m, config.thinning_distance_m),
      returns_(clusterer_.listing_distance_m(), config.link_distance_m),
      points_(config.thinning_distance_m),
      clusters_(config.merge_distance_m) {}

const UpdateReport& ObstacleBase::update(const Scan& scan) {
  const auto first_new = static_cast<PointId>(points_.size());
  read_and_represent(scan, first_new);
  clusterer_.cluster(returns_);
  join_scan_clusters(first_new);

  const std::size_t bridges = clusters_.merge_components(bridged_, points_.points());
  append_new_points();
  const ClusterBase::MergeCounts merged = clusters_.merge_related(points_.points());

  const std::span<ScanCluster> scan_clusters = clusterer_.clusters();
  for (std::size_t i = 0; i < scan_clusters.size(); ++i) {
    scan_clusters[i].cluster = clusters_.living_id(known_cluster_[joined_to_[i]]);
  }
  report_ = {returns_.size(),      returns_.invalid(),  points_.size() - first_new,
             scan_clusters.size(), merged.pairs_tested, bridges + merged.merges};
  if (report_.points_added > 0 || report_.merges > 0) {
    points_at_version_.push_back(static_cast<std::uint32_t>(points_.size()));
  }
  return report_;
}

// Stage 2. Neighbouring returns mostly have the same representative, and the next one is mostly the
// one that followed it before: look-ups are left for new ground, jumps in range and other views.
void ObstacleBase::read_and_represent(const Scan& scan, PointId first_new) {
  const double thinning_sq = config_.thinning_distance_m * config_.thinning_distance_m;
  if (scan.size() > representatives_.size()) representatives_.resize(scan.size());
  Representative* change = representatives_.data();
  PackedPoint current = packed(Vec2::Constant(std::numeric_limits<double>::infinity()));
  std::size_t follower = 0;
  ClusterId label = kNoCluster;
  returns_.read(scan, [&, this](PackedPoint p, std::size_t beam) {
    if (distance_sq(p, current) < thinning_sq) return;
    Known next{followed_by_[follower], false};
    if (next.point == PointIndex::kNone ||
        !(distance_sq(p, packed(points_[next.point])) < thinning_sq)) {
      next = find_or_store(Vec2{p[0], p[1]});
      followed_by_[follower] = next.point;
    }
    current = packed(points_[next.point]);
    follower = std::size_t{next.point} + 1;
    // Those of one cluster bring nothing new to joining.
    const ClusterId label_of_next =
        next.point < first_new ? clusters_.label(next.point) : kNoCluster;
    if (label_of_next == label && label != kNoCluster) return;
    label = label_of_next;
    *change++ = {static_cast<std::uint32_t>(beam), next.point, next.stored_now};
  });
  representative_count_ = static_cast<std::size_t>(change - representatives_.data());
}

ObstacleBase::Known ObstacleBase::find_or_store(const Vec2& p) {
  const PointId nearest = points_.nearest_closer_than(p, config_.thinning_distance_m);
  if (nearest != PointIndex::kNone) return {nearest, false};
  followed_by_.push_back(PointIndex::kNone);
  return {points_.add(p), true};
}

// Stage 3: which clusters of the scan have stored points in common with known clusters, or with
// each other. Known clusters that are bridged so are collected, new points are noted for appending.
void ObstacleBase::join_scan_clusters(PointId first_new) {
  const std::size_t count = clusterer_.clusters().size();
  new_points_.clear();
  joined_to_.resize(count);
  known_cluster_.assign(count, kNoCluster);
  for (std::uint32_t i = 0; i < count; ++i) joined_to_[i] = i;

  const Representative* next = representatives_.data();
  const Representative* const end = next + representative_count_;
  const std::span<const ScanReturns::Run> runs = returns_.runs();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::uint32_t cluster = clusterer_.cluster_of_run(r);
    // A run may begin with the representative of the run before it.
    if (next == end || next->from_beam != runs[r].begin) {
      join(cluster, {runs[r].begin, next[-1].point, false}, first_new);
    }
    for (; next != end && next->from_beam < runs[r].end; ++next) {
      join(cluster, *next, first_new);
    }
  }
}

void ObstacleBase::join(std::uint32_t scan_cluster, const Representative& representative,
                        PointId first_new) {
  const auto root = [this](std::uint32_t i) {
    while (joined_to_[i] != i) i = joined_to_[i];
    return i;
  };
  const auto meet = [this](std::uint32_t i, ClusterId known) {
    if (known == kNoCluster || known_cluster_[i] == known) return;
    if (known_cluster_[i] == kNoCluster) {
      known_cluster_[i] = known;
    } else {
      bridged_.push_back({known_cluster_[i], known});
    }
  };
  if (representative.stored_now) {
    // Returns before the one with which a cluster begins come after its last one.
    const std::uint32_t begin = clusterer_.first_return(scan_cluster);
    const std::uint32_t i = representative.from_beam;
    new_points_.push_back(
        {representative.point, scan_cluster, i < begin ? i + returns_.beams() : i});
  } else if (representative.point < first_new) {
    meet(root(scan_cluster), clusters_.cluster_of(representative.point));
  } else {
    const std::uint32_t a = root(scan_cluster);
    const std::uint32_t b = root(new_points_[representative.point - first_new].scan_cluster);
    if (a == b) return;
    joined_to_[std::max(a, b)] = std::min(a, b);
    meet(std::min(a, b), known_cluster_[std::max(a, b)]);
  }
}

void ObstacleBase::append_new_points() {
  for (std::uint32_t i = 0; i < joined_to_.size(); ++i) {
    // Earlier ones are resolved already.
    joined_to_[i] = joined_to_[joined_to_[i]];
    if (joined_to_[i] == i && known_cluster_[i] == kNoCluster) {
      known_cluster_[i] = clusters_.create();
    }
  }
  const auto by_bearing = [](const NewPoint& a, const NewPoint& b) {
    return std::tie(a.scan_cluster, a.rank) < std::tie(b.scan_cluster, b.rank);
  };
  std::sort(new_points_.begin(), new_points_.end(), by_bearing);
  for (const NewPoint& added : new_points_) {
    const ClusterId known = known_cluster_[joined_to_[added.scan_cluster]];
    clusters_.append(clusters_.living_id(known), added.point, points_.points());
  }
}

}  // namespace voronaut
