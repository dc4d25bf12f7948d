#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "voronaut/environments/scan.h"

// The papers' base of cells: everything a range finder has shown so far, as thinned points that
// belong to clusters.
namespace voronaut {

using PointId = std::uint32_t;
using ClusterId = std::uint32_t;

struct ObstacleBaseConfig {
  double link_distance_m = 0.5;       // returns of one scan closer than this are one cluster
  double thinning_distance_m = 0.08;  // the papers' delta: no two kept points are closer
  double merge_distance_m = 0.8;      // what the vehicle cannot pass: 2 x clearance_min_m

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("link_distance_m", link_distance_m, 0.01, 100);
    v.number("thinning_distance_m", thinning_distance_m, 0.001, 10);
    v.number("merge_distance_m", merge_distance_m, 0, 100);
  }
};

// What one update did.
struct UpdateReport {
  std::size_t returns = 0;       // rays that hit something
  std::size_t invalid = 0;       // NaN, infinite, zero, negative, beyond range: dropped
  std::size_t points_added = 0;  // kept: new ground
  std::size_t clusters_in_scan = 0;
  std::size_t pairs_tested = 0;  // polygon pairs that passed the broad phase
  std::size_t merges = 0;
};

// One cluster of the latest scan, its points in the order of their bearing (right to left).
struct ScanCluster {
  std::vector<Vec2> points_world;
  bool cut_right =
      false;  // begins at the right edge of the field of view: its true extreme is unseen
  bool cut_left = false;  // ends at the left edge
  ClusterId cluster = 0;  // the cluster of the base it belongs to now
};

class ObstacleBase;

// A view of the base as it is now: (version, const view), valid until the next update; copying it
// costs two words. freeze() makes one that lasts.
class ObstacleSnapshot {
 public:
  ObstacleSnapshot() = default;  // an empty base, version 0

  std::uint64_t version() const;  // grows by one with each update that added a point or merged

  // Member points in the order in which they became known. Points never move or vanish.
  std::span<const Vec2> points() const;
  // Points that became known after `version` (a version seen earlier from the same base).
  std::span<const Vec2> points_since(std::uint64_t version) const;

  // Clusters are labels: they say what belongs together, member points alone decide clearance.
  std::size_t cluster_count() const;
  std::vector<ClusterId> clusters() const;  // living ones, ascending. O(clusters)
  ClusterId cluster_of(PointId id) const;
  std::vector<PointId> members(ClusterId id) const;  // in stored order. O(members)
  PointId first_stored(ClusterId id) const;          // of the members in stored order
  PointId last_stored(ClusterId id) const;
  std::span<const Vec2> hull(ClusterId id) const;  // convex, counter-clockwise; 1 or 2 points too

  // Closest member point not farther than within_m. O(cells in reach).
  std::optional<PointId> nearest(const Vec2& p, double within_m) const;
  // True if no member point is closer than radius_m to p / to the segment a-b (a swept disc,
  // exact).
  bool disc_is_clear(const Vec2& p, double radius_m) const;
  bool swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const;
  // Smallest distance from the segment a-b to a member point, capped at within_m.
  double segment_clearance_m(const Vec2& a, const Vec2& b, double within_m) const;

  // A copy that outlives updates, for logs.
  std::shared_ptr<const ObstacleBase> freeze() const;

 private:
  friend class ObstacleBase;
  explicit ObstacleSnapshot(const ObstacleBase* base) : base_(base) {}
  const ObstacleBase* base_ = nullptr;
};

}  // namespace voronaut
