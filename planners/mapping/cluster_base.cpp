#include "voronaut/planners/mapping/cluster_base.h"

#include <algorithm>

#include "voronaut/planners/mapping/convex_polygon.h"

namespace voronaut {
namespace {

// Most clusters of a scan that sees a few metres are smaller than this.
constexpr double kFinestBoxCellM = 2;

// The broad phase asks for a little more, so that rounding cannot lose a pair.
constexpr double kRoundingMargin = 1 + 1e-9;

Bounds grown(const Bounds& box, double margin_m) {
  return {box.min - Vec2::Constant(margin_m), box.max + Vec2::Constant(margin_m)};
}

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

void ClusterBase::append(ClusterId id, PointId point, std::span<const Vec2> points) {
  const Vec2& p = points[point];
  Cluster& cluster = clusters_[id];
  if (point >= label_.size()) {
    label_.resize(point + 1);
    next_member_.resize(point + 1);
  }
  label_[point] = id;
  next_member_[point] = kNone;
  if (cluster.first == kNone) {
    cluster.first = point;
    cluster.box = {p, p};
  } else {
    next_member_[cluster.last] = point;
    grow_to_hold(cluster.box, p);
  }
  cluster.last = point;
  add_to_convex_hull(cluster.hull, p, cluster.newest_vertex);
  boxes_.place(id, cluster.box);
  mark_changed(id);
}

void ClusterBase::unite(ClusterId older, ClusterId younger) {
  Cluster& a = clusters_[older];
  Cluster& b = clusters_[younger];
  next_member_[a.last] = b.first;
  a.last = b.last;
  grow_to_hold(a.box, b.box.min);
  grow_to_hold(a.box, b.box.max);
  a.hull.insert(a.hull.end(), b.hull.begin(), b.hull.end());
  reduce_to_convex_hull(a.hull);
  b.hull = {};
  merged_into_[younger] = older;
  boxes_.place(older, a.box);
  boxes_.remove(younger);
  --living_;
  mark_changed(older);
}

ClusterId ClusterBase::component_of(ClusterId id) const {
  while (clusters_[id].component != id) id = clusters_[id].component;
  return id;
}

std::size_t ClusterBase::merge_components(std::vector<Pair>& pairs) {
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
    unite(oldest, id);
    ++merges;
  }
  for (const ClusterId id : in_pairs_) clusters_[id].component = id;
  return merges;
}

bool ClusterBase::related(const Cluster& a, const Cluster& b, std::span<const Vec2> points,
                          MergeCounts& counts) const {
  if (boxes_touch(a.box, b.box)) {
    ++counts.pairs_tested;
    if (convex_polygons_touch_in_boxes(a.hull, b.hull)) return true;
  }
  const double merge_sq = merge_distance_m_ * merge_distance_m_;
  for (const PointId i : {a.first, a.last}) {
    for (const PointId j : {b.first, b.last}) {
      if (distance_sq(points[i], points[j]) < merge_sq) return true;
    }
  }
  return false;
}

void ClusterBase::collect_related(ClusterId id, std::span<const Vec2> points, MergeCounts& counts) {
  const Cluster& cluster = clusters_[id];
  const Bounds reach = grown(cluster.box, merge_distance_m_ * kRoundingMargin);
  boxes_.for_each_near(reach, [&](ClusterId other) {
    const Cluster& candidate = clusters_[other];
    if (!boxes_touch(reach, candidate.box)) return;
    // A pair of changed clusters is asked once, from its older one.
    if (other == id || (candidate.changed && other < id)) return;
    if (related(cluster, candidate, points, counts)) related_.push_back({id, other});
  });
}

ClusterBase::MergeCounts ClusterBase::merge_related(std::span<const Vec2> points) {
  MergeCounts counts;
  while (!changed_.empty()) {
    for (const ClusterId id : changed_) {
      if (merged_into_[id] == id) collect_related(id, points, counts);
    }
    for (const ClusterId id : changed_) clusters_[id].changed = false;
    changed_.clear();
    counts.merges += merge_components(related_);
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
  for (PointId p = first_stored(id); p != kNone; p = next_member_[p]) ids.push_back(p);
  return ids;
}

}  // namespace voronaut
