#include "voronaut/planners/mapping/scan_clusterer.h"

#include <algorithm>
#include <limits>

namespace voronaut {
namespace {

// Square of the distance between two boxes.
double distance_sq(const Bounds& a, const Bounds& b) {
  const double x = std::max({a.min.x() - b.max.x(), b.min.x() - a.max.x(), 0.0});
  const double y = std::max({a.min.y() - b.max.y(), b.min.y() - a.max.y(), 0.0});
  return x * x + y * y;
}

}  // namespace

ScanClusterer::ScanClusterer(double link_distance_m, double thinning_distance_m)
    : link_distance_m_(link_distance_m), thinning_distance_m_(thinning_distance_m) {}

void ScanClusterer::cluster(const ScanReturns& returns) {
  split_into_runs(returns);
  link_runs(returns.points_world());
  list_clusters(returns);
  if (returns.full_circle()) begin_behind_widest_gap(returns);
}

// A return is listed if it begins a run or is not closer than the thinning distance to the one
// listed before it.
void ScanClusterer::split_into_runs(const ScanReturns& returns) {
  const std::span<const Vec2> points = returns.points_world();
  const double link_sq = link_distance_m_ * link_distance_m_;
  const double thinning_sq = thinning_distance_m_ * thinning_distance_m_;
  // Two returns that are closer than the thinning distance to the same one are then surely linked.
  const bool thinned_is_linked = 2 * thinning_distance_m_ < link_distance_m_;
  runs_.clear();
  listed_.clear();
  Vec2 last_listed = Vec2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = points[i];
    const auto index = static_cast<std::uint32_t>(i);
    const bool thinned = i > 0 && (p - last_listed).squaredNorm() < thinning_sq;
    if (thinned && thinned_is_linked) continue;
    const bool linked = i > 0 && (p - points[i - 1]).squaredNorm() < link_sq;
    if (linked && thinned) continue;
    const auto listed = static_cast<std::uint32_t>(listed_.size());
    listed_.push_back(index);
    last_listed = p;
    if (linked) {
      Bounds& box = runs_.back().box;
      box = {box.min.cwiseMin(p), box.max.cwiseMax(p)};
      continue;
    }
    if (!runs_.empty()) {
      runs_.back().end = index;
      runs_.back().listed_end = listed;
    }
    runs_.push_back({index, 0, listed, 0, 0, {p, p}});
  }
  if (runs_.empty()) return;
  runs_.back().end = static_cast<std::uint32_t>(points.size());
  runs_.back().listed_end = static_cast<std::uint32_t>(listed_.size());
}

// Listed returns decide nearly always: every return is closer than the thinning distance to a
// listed one of its run.
bool ScanClusterer::runs_linked(const Run& a, const Run& b, std::span<const Vec2> points) const {
  const double link_sq = link_distance_m_ * link_distance_m_;
  const double reach_m = link_distance_m_ + 2 * thinning_distance_m_;
  const double reach_sq = reach_m * reach_m;
  if (distance_sq(a.box, b.box) > reach_sq) return false;
  bool undecided = false;
  for (std::uint32_t i = a.listed_begin; i < a.listed_end; ++i) {
    const Vec2 p = points[listed_[i]];
    if (distance_sq({p, p}, b.box) > reach_sq) continue;
    for (std::uint32_t j = b.listed_begin; j < b.listed_end; ++j) {
      const double apart_sq = (p - points[listed_[j]]).squaredNorm();
      if (apart_sq < link_sq) return true;
      undecided = undecided || apart_sq <= reach_sq;
    }
  }
  if (!undecided) return false;
  const double near_box_m = link_distance_m_ + thinning_distance_m_;
  for (std::uint32_t i = a.begin; i < a.end; ++i) {
    const Vec2 p = points[i];
    if (distance_sq({p, p}, b.box) > near_box_m * near_box_m) continue;
    for (std::uint32_t j = b.begin; j < b.end; ++j) {
      if ((p - points[j]).squaredNorm() < link_sq) return true;
    }
  }
  return false;
}

// Leaves in each run the number of its cluster, counted in the order of the first runs.
void ScanClusterer::link_runs(std::span<const Vec2> points) {
  const auto count = static_cast<std::uint32_t>(runs_.size());
  const auto root = [this](std::uint32_t run) {
    while (runs_[run].cluster != run) run = runs_[run].cluster;
    return run;
  };
  for (std::uint32_t j = 0; j < count; ++j) {
    runs_[j].cluster = j;
    for (std::uint32_t i = 0; i < j; ++i) {
      const std::uint32_t a = root(i);
      const std::uint32_t b = root(j);
      if (a != b && runs_linked(runs_[i], runs_[j], points))
        runs_[std::max(a, b)].cluster = std::min(a, b);
    }
  }
  std::uint32_t clusters = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    // A root is the first run of its cluster, so it has its number when the others ask for it.
    runs_[i].cluster = runs_[i].cluster == i ? clusters++ : runs_[runs_[i].cluster].cluster;
  }
  cluster_count_ = clusters;
}

void ScanClusterer::list_clusters(const ScanReturns& returns) {
  const std::span<const Vec2> points = returns.points_world();
  if (cluster_count_ > clusters_.size()) {
    clusters_.resize(cluster_count_);
    first_return_.resize(cluster_count_);
  }
  for (ScanCluster& cluster : clusters()) cluster.points_world.clear();
  for (const Run& run : runs_) {
    ScanCluster& cluster = clusters_[run.cluster];
    if (cluster.points_world.empty()) {
      first_return_[run.cluster] = run.begin;
      cluster.cut_right =
          !returns.full_circle() && returns.beams()[run.begin] == returns.first_measured();
    }
    cluster.cut_left =
        !returns.full_circle() && returns.beams()[run.end - 1] == returns.last_measured();
    for (std::uint32_t i = run.listed_begin; i < run.listed_end; ++i) {
      cluster.points_world.push_back(points[listed_[i]]);
    }
  }
}

void ScanClusterer::begin_behind_widest_gap(const ScanReturns& returns) {
  const std::span<const std::uint32_t> beams = returns.beams();
  for (std::uint32_t c = 0; c < cluster_count_; ++c) {
    std::uint32_t widest = 0;
    std::uint32_t begin = 0;
    std::uint32_t listed_before = 0;
    std::uint32_t listed = 0;
    bool first = true;
    std::uint32_t previous = 0;
    for (const Run& run : runs_) {
      if (run.cluster != c) continue;
      std::uint32_t next_listed = run.listed_begin;
      for (std::uint32_t i = run.begin; i < run.end; ++i) {
        const std::uint32_t gap = first ? 0 : beams[i] - previous;
        if (gap > widest) {
          widest = gap;
          begin = i;
          listed_before = listed;
        }
        if (next_listed < run.listed_end && listed_[next_listed] == i) {
          ++next_listed;
          ++listed;
        }
        first = false;
        previous = beams[i];
      }
    }
    const auto seam =
        static_cast<std::uint32_t>(beams[first_return_[c]] + returns.beams_in_scan() - previous);
    if (widest <= seam) continue;
    first_return_[c] = begin;
    std::vector<Vec2>& world = clusters_[c].points_world;
    std::rotate(world.begin(), world.begin() + static_cast<std::ptrdiff_t>(listed_before),
                world.end());
  }
}

}  // namespace voronaut
