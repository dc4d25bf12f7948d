#include "voronaut/planners/mapping/obstacle_base.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "voronaut/planners/mapping/points/convex_polygon.h"

namespace voronaut {
namespace {

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
  joining_.join(returns_, clusterer_, {representatives_.data(), representative_count_}, first_new,
                clusters_);
  const std::size_t bridges = clusters_.merge_components(joining_.bridged(), points_.points());
  joining_.append_new_points(clusters_, points_.points());
  const ClusterBase::MergeCounts merged = clusters_.merge_related(points_.points());

  const std::span<ScanCluster> scan_clusters = clusterer_.clusters();
  for (std::size_t i = 0; i < scan_clusters.size(); ++i) {
    scan_clusters[i].cluster = clusters_.living_id(joining_.cluster_of(i));
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
  const double thinning_m = config_.thinning_distance_m;
  const double thinning_sq = thinning_m * thinning_m;
  if (scan.size() > representatives_.size()) representatives_.resize(scan.size());
  representative_count_ = 0;
  PackedPoint current = packed(Vec2::Constant(std::numeric_limits<double>::infinity()));
  ClusterId label = kNoCluster;
  std::size_t left_behind = 0;
  returns_.read(scan, [&, this](PackedPoint p, std::size_t beam) {
    if (distance_sq(p, current) < thinning_sq) return;
    Follower next = followers_[left_behind];
    bool stored_now = false;
    if (next.point == PointIndex::kNone ||
        !(distance_sq(p, packed(points_[next.point])) < thinning_sq)) {
      next = represented(p, stored_now);
      followers_[left_behind] = next;
    }
    current = packed(points_[next.point]);
    const std::size_t before = std::exchange(left_behind, std::size_t{next.point} + 1);
    // Points of one label bring nothing new to joining.
    if (next.same_label) return;
    const ClusterId next_label = next.point < first_new ? clusters_.label(next.point) : kNoCluster;
    if (next_label == label && label != kNoCluster) {
      followers_[before].same_label = true;
      return;
    }
    label = next_label;
    representatives_[representative_count_++] = {static_cast<std::uint32_t>(beam), next.point,
                                                 stored_now};
  });
}

ObstacleBase::Follower ObstacleBase::represented(PackedPoint p, bool& stored_now) {
  const Vec2 p_world{p[0], p[1]};
  Follower found{points_.nearest_closer_than(p_world, config_.thinning_distance_m)};
  stored_now = found.point == PointIndex::kNone;
  if (stored_now) found.point = store(p_world);
  return found;
}

PointId ObstacleBase::store(const Vec2& p) {
  followers_.emplace_back();
  return points_.add(p);
}

}  // namespace voronaut
