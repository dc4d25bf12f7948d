#include "voronaut/planners/mapping/stages/cluster_base.h"

#include <algorithm>

#include "voronaut/planners/mapping/points/convex_polygon.h"

namespace voronaut {
namespace {

// Most clusters of a scan that sees a few metres are smaller than this.
constexpr double kFinestBoxCellM = 2;

// The broad phase asks for a little more, so that rounding cannot lose a pair.
constexpr double kMergeRoundingMargin = 1 + 1e-9;

}  // namespace

ClusterBase::ClusterBase(double merge_distance_m)
    : merge_distance_m_(merge_distance_m), boxes_(kFinestBoxCellM) {}

ClusterId ClusterBase::create() {
  const auto id = static_cast<ClusterId>(clusters_.size());
  Cluster& cluster = clusters_.emplace_back();
  cluster.component = id;
  merged_into_.push_back(id);
  ++living_;
  return id;
}

void ClusterBase::mark_changed(ClusterId id) {
  if (clusters_[id].changed) return;
  clusters_[id].changed = true;
  changed_.push_back(id);
}

void ClusterBase::append(ClusterId id, PointId point, const Vec2& p) {
  Cluster& cluster = clusters_[id];
  members_[point] = {id, kNone};
  if (cluster.first == kNone) {
    cluster.first = point;
    cluster.box = {p, p};
  } else {
    members_[cluster.last].next = point;
    grow_to_hold(cluster.box, p);
  }
  cluster.last = point;
  mark_changed(id);
}

void ClusterBase::complete_hull(Cluster& cluster, std::span<const Vec2> points) {
  if (cluster.last_in_hull == cluster.last) return;
  PointId p = cluster.last_in_hull == kNone ? cluster.first : members_[cluster.last_in_hull].next;
  for (; p != kNone; p = members_[p].next) {
    add_to_convex_hull(cluster.hull, points[p], cluster.newest_vertex);
  }
  cluster.last_in_hull = cluster.last;
}

// Before their members are united. No member is added to a hull more than once.
void ClusterBase::unite_hulls(Cluster& a, Cluster& b, std::span<const Vec2> points) {
  if (a.last_in_hull == kNone && b.last_in_hull == kNone) return;
  complete_hull(a, points);
  complete_hull(b, points);
  a.hull.insert(a.hull.end(), b.hull.begin(), b.hull.end());
  reduce_to_convex_hull(a.hull);
  a.last_in_hull = b.last;
  b.hull = {};
}

void ClusterBase::unite(ClusterId older, ClusterId younger, std::span<const Vec2> points) {
  Cluster& a = clusters_[older];
  Cluster& b = clusters_[younger];
  unite_hulls(a, b, points);
  members_[a.last].next = b.first;
  a.last = b.last;
  grow_to_hold(a.box, b.box.min);
  grow_to_hold(a.box, b.box.max);
  merged_into_[younger] = older;
  boxes_.remove(younger);
  --living_;
  mark_changed(older);
}

ClusterId ClusterBase::component_of(ClusterId id) const {
  while (clusters_[id].component != id) id = clusters_[id].component;
  return id;
}

std::size_t ClusterBase::merge_components(std::vector<Pair>& pairs, std::span<const Vec2> points) {
  if (pairs.empty()) return 0;
  in_pairs_.clear();
  for (const Pair& pair : pairs) {
    const ClusterId a = component_of(pair.a);
    const ClusterId b = component_of(pair.b);
    clusters_[std::max(a, b)].component = std::min(a, b);
    in_pairs_.push_back(pair.a);
    in_pairs_.push_back(pair.b);
  }
  pairs.clear();
  std::sort(in_pairs_.begin(), in_pairs_.end());
  std::size_t merges = 0;
  for (const ClusterId id : in_pairs_) {
    if (merged_into_[id] != id) continue;  // listed twice
    const ClusterId oldest = component_of(id);
    if (oldest == id) continue;
    unite(oldest, id, points);
    ++merges;
  }
  for (const ClusterId id : in_pairs_) clusters_[id].component = id;
  return merges;
}

// Extreme points first: they are asked at once, and mostly they decide before boxes touch.
bool ClusterBase::related(Cluster& a, Cluster& b, std::span<const Vec2> points,
                          MergeCounts& counts) {
  const double merge_sq = merge_distance_m_ * merge_distance_m_;
  for (const PointId i : {a.first, a.last}) {
    for (const PointId j : {b.first, b.last}) {
      if (distance_sq(points[i], points[j]) < merge_sq) return true;
    }
  }
  if (!boxes_touch(a.box, b.box)) return false;
  ++counts.pairs_tested;
  complete_hull(a, points);
  complete_hull(b, points);
  return convex_polygons_touch_in_boxes(a.hull, b.hull);
}

void ClusterBase::collect_related(ClusterId id, std::span<const Vec2> points, MergeCounts& counts) {
  Cluster& cluster = clusters_[id];
  const Bounds reach = grown(cluster.box, merge_distance_m_ * kMergeRoundingMargin);
  boxes_.for_each_near(reach, [&](ClusterId other) {
    Cluster& candidate = clusters_[other];
    if (!boxes_touch(reach, candidate.box)) return;
    // A pair of changed clusters is asked once, from its older one.
    if (other == id || (candidate.changed && other < id)) return;
    if (related(cluster, candidate, points, counts)) related_.push_back({id, other});
  });
}

ClusterBase::MergeCounts ClusterBase::merge_related(std::span<const Vec2> points) {
  MergeCounts counts;
  while (!changed_.empty()) {
    for (const ClusterId id : changed_) boxes_.place(id, clusters_[id].box);
    for (const ClusterId id : changed_) collect_related(id, points, counts);
    for (const ClusterId id : changed_) clusters_[id].changed = false;
    changed_.clear();
    counts.merges += merge_components(related_, points);
  }
  return counts;
}

std::vector<ClusterId> ClusterBase::living_ids() const {
  std::vector<ClusterId> ids;
  ids.reserve(living_);
  for (ClusterId id = 0; id < clusters_.size(); ++id) {
    if (merged_into_[id] == id) ids.push_back(id);
  }
  return ids;
}

std::vector<PointId> ClusterBase::members(ClusterId id) const {
  std::vector<PointId> ids;
  for (PointId p = first_stored(id); p != kNone; p = members_[p].next) ids.push_back(p);
  return ids;
}

std::vector<Vec2> ClusterBase::hull(ClusterId id, std::span<const Vec2> points) const {
  std::vector<Vec2> hull;
  for (const PointId p : members(id)) hull.push_back(points[p]);
  reduce_to_convex_hull(hull);
  return hull;
}

}  // namespace voronaut
