#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/planners/mapping/index/point_index.h"
#include "voronaut/planners/mapping/obstacle_snapshot.h"
#include "voronaut/planners/mapping/points/packed_point.h"
#include "voronaut/planners/mapping/points/scan_cluster.h"
#include "voronaut/planners/mapping/stages/cluster_base.h"
#include "voronaut/planners/mapping/stages/scan_clusterer.h"
#include "voronaut/planners/mapping/stages/scan_joining.h"
#include "voronaut/planners/mapping/stages/scan_returns.h"

// The papers' base of cells: everything a range finder has shown so far, as thinned points that
// belong to clusters.
namespace voronaut {

struct ObstacleBaseConfig {
  double link_distance_m = 0.5;
  double thinning_distance_m = 0.08;
  double merge_distance_m = 0.8;

  template <class Visitor>
  void visit(Visitor& v) {
    v.number("link_distance_m", link_distance_m, 0.01, 100,
             "Returns of one scan closer than this are one cluster");
    v.number("thinning_distance_m", thinning_distance_m, 0.001, 10,
             "The papers' delta: no two kept points are closer");
    v.number(
        "merge_distance_m", merge_distance_m, 0, 100,
        "Clusters closer than this are one: what the vehicle cannot pass, 2 planning_clearance_m");
  }
};

// What one update did.
struct UpdateReport {
  std::size_t returns = 0;       // rays that hit something
  std::size_t invalid = 0;       // NaN, infinite, zero, negative, beyond range: dropped
  std::size_t points_added = 0;  // kept: new ground
  std::size_t clusters_in_scan = 0;
  std::size_t pairs_tested = 0;  // polygon pairs that passed the broad phase
  std::size_t merges = 0;        // clusters that became part of an older one
};

// update() runs the papers' four stages on one scan:
//
// 1. Single linkage. Two returns belong to one cluster of the scan if they are closer than
//    link_distance_m or a chain of such returns joins them (the papers' full search).
// 2. Thinning. A return is known if a stored point is closer than thinning_distance_m, else it is
//    stored, in the order of the beams. So no two stored points are closer than that, every return
//    ever seen has a stored point closer than that, and neither depends on clusters. A known return
//    is represented by a stored point closer than thinning_distance_m: the one of the return before
//    it; else the one that last came next after that one in a scan; else the nearest (the earliest
//    stored of equals).
// 3. Joining. A cluster of the scan and the known clusters of its representatives have these points
//    in common, so they are one cluster: known members first (older clusters first), then the new
//    points in the order of their bearing. A cluster that shares no point with the base is a new
//    one.
// 4. Merging. Two clusters become one if their polygons (convex hulls) have a common point, or else
//    if one of the extreme points of the one is closer than merge_distance_m to one of the other;
//    extreme are the first and the last stored member, as the papers have it. All pairs are
//    asked at once, all that are connected merge at once (members of older clusters first, under
//    the oldest id), and again until no pair is left to merge. Thus the result depends on no order
//    of examination, and only pairs of which one changed in this update need to be asked.
class ObstacleBase {
 public:
  // Throws std::invalid_argument if a distance is not a positive finite number (merging: >= 0).
  explicit ObstacleBase(const ObstacleBaseConfig& config);

  // The scan's ranges and beams must be equally many. The report is valid until the next update.
  const UpdateReport& update(const Scan& scan);

  ObstacleSnapshot snapshot() const { return {this, version()}; }
  // Of the latest scan, in the order of their first beams; valid until the next update.
  std::span<const ScanCluster> scan_clusters() const { return clusterer_.clusters(); }
  const UpdateReport& report() const { return report_; }
  const ObstacleBaseConfig& config() const { return config_; }

 private:
  friend class ObstacleSnapshot;

  // Which point represented the next returns when last a point was left behind.
  struct Follower {
    PointId point = PointIndex::kNone;
    bool same_label = false;  // as the one left behind; false while that is not noticed
  };

  std::uint64_t version() const { return points_at_version_.size() - 1; }
  void read_and_represent(const Scan& scan, PointId first_new);
  // The known point closer than the thinning distance, or else p itself, stored now.
  Follower represented(PackedPoint p, bool& stored_now);
  [[gnu::noinline]] PointId store(const Vec2& p);

  ObstacleBaseConfig config_;
  UpdateReport report_;
  ScanClusterer clusterer_;
  ScanReturns returns_;
  PointIndex points_;
  ScanJoining joining_;
  ClusterBase clusters_;
  std::vector<std::uint32_t> points_at_version_{0};
  // Entry 0 for the beginning of a scan, then one for each stored point.
  std::vector<Follower> followers_{{}};

  // Of one update, kept so that a scan without news allocates nothing.
  std::vector<Representative> representatives_;  // the first representative_count_ are in use
  std::size_t representative_count_ = 0;
};

}  // namespace voronaut
