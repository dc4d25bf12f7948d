#include "voronaut/planners/mapping/obstacle_base.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

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
    scan_clusters[i].cluster = clusters_.living_id(joined_[joined_[i].to].known);
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
  if (scan.size() > representatives_.size()) make_room(scan.size());
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
      const Vec2 p_world{p[0], p[1]};
      next = {points_.nearest_closer_than(p_world, thinning_m)};
      stored_now = next.point == PointIndex::kNone;
      if (stored_now) next.point = store(p_world);
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

PointId ObstacleBase::store(const Vec2& p) {
  followers_.emplace_back();
  return points_.add(p);
}

// A scan has no more representatives, new points and clusters than beams.
void ObstacleBase::make_room(std::size_t beams) {
  representatives_.resize(beams);
  new_points_.resize(beams);
  joined_.resize(beams);
}

// Stage 3: which clusters of the scan have stored points in common with known clusters, or with
// each other. Known clusters that are bridged so are collected, new points are noted for appending.
void ObstacleBase::join_scan_clusters(PointId first_new) {
  new_point_count_ = 0;
  const std::size_t count = clusterer_.clusters().size();
  for (std::uint32_t i = 0; i < count; ++i) joined_[i] = {i, kNoCluster};

  const Representative* next = representatives_.data();
  const Representative* const end = next + representative_count_;
  const std::span<const ScanReturns::Run> runs = returns_.runs();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const std::uint32_t cluster = clusterer_.cluster_of_run(r);
    // A run may begin with the representative of the run before it.
    if (next == end || next->from_beam != runs[r].begin) join(cluster, next[-1].point, first_new);
    for (; next != end && next->from_beam < runs[r].end; ++next) {
      if (next->stored_now) {
        note_new_point(cluster, *next);
      } else {
        join(cluster, next->point, first_new);
      }
    }
  }
}

void ObstacleBase::note_new_point(std::uint32_t scan_cluster, const Representative& stored) {
  // Returns before the one with which a cluster begins come after its last one.
  const std::uint32_t begin = clusterer_.first_return(scan_cluster);
  const std::uint32_t beam = stored.from_beam;
  const std::uint32_t rank = beam < begin ? beam + returns_.beams() : beam;
  new_points_[new_point_count_++] = {stored.point, scan_cluster, rank};
}

void ObstacleBase::join(std::uint32_t scan_cluster, PointId point, PointId first_new) {
  const auto root = [this](std::uint32_t i) {
    while (joined_[i].to != i) i = joined_[i].to;
    return i;
  };
  const std::uint32_t a = root(scan_cluster);
  if (point < first_new) {
    meet(a, clusters_.cluster_of(point));
    return;
  }
  const std::uint32_t b = root(new_points_[point - first_new].scan_cluster);
  if (a == b) return;
  joined_[std::max(a, b)].to = std::min(a, b);
  meet(std::min(a, b), joined_[std::max(a, b)].known);
}

void ObstacleBase::meet(std::uint32_t scan_cluster, ClusterId known) {
  ClusterId& first_met = joined_[scan_cluster].known;
  if (known == kNoCluster || known == first_met) return;
  if (first_met == kNoCluster) {
    first_met = known;
  } else {
    bridged_.push_back({first_met, known});
  }
}

void ObstacleBase::append_new_points() {
  const std::size_t count = clusterer_.clusters().size();
  for (std::uint32_t i = 0; i < count; ++i) {
    // Earlier ones are resolved already.
    joined_[i].to = joined_[joined_[i].to].to;
    if (joined_[i].to == i && joined_[i].known == kNoCluster) joined_[i].known = clusters_.create();
  }
  if (new_point_count_ == 0) return;
  const auto by_bearing = [](const NewPoint& a, const NewPoint& b) {
    return std::tie(a.scan_cluster, a.rank) < std::tie(b.scan_cluster, b.rank);
  };
  const std::span<NewPoint> new_points{new_points_.data(), new_point_count_};
  if (!std::ranges::is_sorted(new_points, by_bearing)) std::ranges::sort(new_points, by_bearing);
  clusters_.make_room(points_.size());
  for (const NewPoint& added : new_points) {
    const ClusterId known = joined_[joined_[added.scan_cluster].to].known;
    clusters_.append(clusters_.living_id(known), added.point, points_[added.point]);
  }
}

}  // namespace voronaut
