#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/points/scan_cluster.h"

namespace voronaut {

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
  // An id whose cluster was merged into another stands for that other one.
  std::size_t cluster_count() const;
  std::vector<ClusterId> clusters() const;  // living ones, ascending. O(clusters ever made)
  ClusterId cluster_of(PointId id) const;
  std::vector<PointId> members(ClusterId id) const;  // in stored order. O(members)
  PointId first_stored(ClusterId id) const;          // of the members in stored order
  PointId last_stored(ClusterId id) const;
  // Strictly convex, counter-clockwise, from the lexicographically smallest vertex; of one or two
  // vertices too. O(members log members).
  std::vector<Vec2> hull(ClusterId id) const;

  // Closest member point not farther than within_m, the earliest known of equally close ones.
  // O(cells in reach).
  std::optional<PointId> nearest(const Vec2& p, double within_m) const;
  // True if no member point is closer than radius_m to p / to the segment a-b (a swept disc,
  // exact).
  bool disc_is_clear(const Vec2& p, double radius_m) const;
  bool swept_disc_is_clear(const Vec2& a, const Vec2& b, double radius_m) const;
  // Makes these two fast for this radius until the next update, for whoever is about to ask often:
  // some hundred instructions per point that became known since the last call (per point known, if
  // the radius is another). Not while another thread asks.
  void expect_checks(double radius_m) const;
  // Smallest distance from the segment a-b to a member point, capped at within_m.
  double segment_clearance_m(const Vec2& a, const Vec2& b, double within_m) const;

  // A copy that outlives updates, for logs. O(base); null of an empty default snapshot.
  std::shared_ptr<const ObstacleBase> freeze() const;

 private:
  friend class ObstacleBase;
  ObstacleSnapshot(const ObstacleBase* base, std::uint64_t version)
      : base_(base), version_(version) {}
  const ObstacleBase* base_ = nullptr;
  std::uint64_t version_ = 0;
};

}  // namespace voronaut
