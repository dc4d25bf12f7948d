#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "voronaut/planners/mapping/index/box_grid.h"
#include "voronaut/planners/mapping/points/scan_cluster.h"

namespace voronaut {

// Which points belong together: labels, members in stored order, and the papers' stage 4 that
// merges clusters. It decides nothing about clearance. Cluster ids count up from 0; of merged
// clusters the oldest id lives on and the others stand for it. Points are named by id, and their
// coordinates are lent to each call that needs them. Of most clusters nothing ever asks for the
// convex hull, because no other box touches theirs: it is brought up to date when it is asked for.
class ClusterBase {
 public:
  struct Pair {
    ClusterId a = 0;
    ClusterId b = 0;
  };
  struct MergeCounts {
    std::size_t pairs_tested = 0;  // polygon pairs that passed the broad phase
    std::size_t merges = 0;
  };

  explicit ClusterBase(double merge_distance_m);

  // A new cluster without members; append() at least one before anything else.
  ClusterId create();
  // For that many points.
  void make_room(std::size_t points) {
    if (points > members_.size()) members_.resize(points);
  }
  // Points are appended in the order of their ids or not, each exactly once, where room was made.
  // O(1).
  void append(ClusterId id, PointId point, const Vec2& p);

  // Makes one cluster of each connected component of the pairs: the members of older clusters
  // first. Returns the number of clusters that ceased. The pairs are living ids, and are consumed.
  std::size_t merge_components(std::vector<Pair>& pairs, std::span<const Vec2> points);

  // Stage 4 (see ObstacleBase) for all clusters that changed since the last call.
  MergeCounts merge_related(std::span<const Vec2> points);

  std::size_t living() const { return living_; }
  std::vector<ClusterId> living_ids() const;
  // The living cluster that an id stands for. O(merges on its way, nearly always 0 or 1).
  ClusterId living_id(ClusterId id) const {
    while (merged_into_[id] != id) id = merged_into_[id];
    return id;
  }
  // The cluster that a point was stored in, living or not.
  ClusterId label(PointId point) const { return members_[point].label; }
  ClusterId cluster_of(PointId point) const { return living_id(label(point)); }

  // The following take any id and answer for the living cluster it stands for.
  std::vector<PointId> members(ClusterId id) const;
  // From its members anew: O(members log members).
  std::vector<Vec2> hull(ClusterId id, std::span<const Vec2> points) const;
  PointId first_stored(ClusterId id) const { return clusters_[living_id(id)].first; }
  PointId last_stored(ClusterId id) const { return clusters_[living_id(id)].last; }

 private:
  static constexpr PointId kNone = 0xffff'ffff;

  struct Member {
    ClusterId label = 0;   // the cluster it was stored in
    PointId next = kNone;  // of the same cluster, in stored order
  };
  struct Cluster {
    ClusterId component = 0;  // itself except inside merge_components()
    PointId first = kNone;
    PointId last = kNone;
    bool changed = false;
    Bounds box;
    PointId last_in_hull = kNone;  // the hull is that of the members up to this one
    std::vector<Vec2> hull;
    std::size_t newest_vertex = 0;  // of the hull, while no other cluster joined it
  };

  ClusterId component_of(ClusterId id) const;
  void mark_changed(ClusterId id);
  void unite(ClusterId older, ClusterId younger, std::span<const Vec2> points);
  void complete_hull(Cluster& cluster, std::span<const Vec2> points);
  void unite_hulls(Cluster& a, Cluster& b, std::span<const Vec2> points);
  bool related(Cluster& a, Cluster& b, std::span<const Vec2> points, MergeCounts& counts);
  void collect_related(ClusterId id, std::span<const Vec2> points, MergeCounts& counts);

  double merge_distance_m_;
  std::vector<Cluster> clusters_;
  std::vector<ClusterId> merged_into_;  // of each cluster: itself while it lives
  std::size_t living_ = 0;
  BoxGrid boxes_;
  std::vector<Member> members_;     // each point
  std::vector<ClusterId> changed_;  // living, each once; their boxes are placed when they are asked
  std::vector<Pair> related_;       // of the round under way
  std::vector<ClusterId> in_pairs_;  // scratch of merge_components()
};

}  // namespace voronaut
