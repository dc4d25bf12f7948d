#include "voronaut/planners/mapping/scan_clusterer.h"

#include <algorithm>
#include <limits>

#include "voronaut/planners/mapping/convex_polygon.h"

namespace voronaut {
namespace {

double box_distance_sq(const Bounds& a, const Bounds& b) {
  const double x = std::max({a.min.x() - b.max.x(), b.min.x() - a.max.x(), 0.0});
  const double y = std::max({a.min.y() - b.max.y(), b.min.y() - a.max.y(), 0.0});
  return x * x + y * y;
}

}  // namespace

ScanClusterer::ScanClusterer(double link_distance_m, double thinning_distance_m)
    : link_distance_m_(link_distance_m),
      listing_distance_m_(std::min(thinning_distance_m, link_distance_m / 2)) {}

void ScanClusterer::cluster(const ScanReturns& returns) {
  split_into_runs(returns);
  link_runs(returns);
  list_clusters(returns);
}

// Only a jump can begin a run: the return before a listed one is closer than the listing distance
// to the one listed before, and so are those between.
void ScanClusterer::split_into_runs(const ScanReturns& returns) {
  const std::span<const Vec2> points = returns.points_world();
  const std::span<const std::uint32_t> listed = returns.listed();
  const double link_sq = link_distance_m_ * link_distance_m_;
  runs_.clear();
  listed_world_ = returns.listed_world();
  if (listed.size() > gathered_world_.size()) gathered_world_.resize(listed.size());
  for (const std::uint32_t k : returns.jumps()) {
    const std::uint32_t i = listed[k];
    if (k > 0) {
      if (distance_sq(points[i], points[i - 1]) < link_sq) continue;
      runs_.back().end = i;
      runs_.back().listed_end = k;
    }
    Run& run = runs_.emplace_back();
    run.begin = i;
    run.listed_begin = k;
  }
  if (runs_.empty()) return;
  runs_.back().end = static_cast<std::uint32_t>(points.size());
  runs_.back().listed_end = static_cast<std::uint32_t>(listed.size());
}

// Listed returns decide mostly. Each stands for the returns up to the next listed one, all closer
// than the listing distance to it: where two are apart by little more than the link distance,
// these are compared.
bool ScanClusterer::runs_linked(const Run& a, const Run& b, const ScanReturns& returns) const {
  const double link_sq = link_distance_m_ * link_distance_m_;
  const double reach_m = link_distance_m_ + 2 * listing_distance_m_;
  const double reach_sq = reach_m * reach_m;
  if (box_distance_sq(a.box, b.box) > reach_sq) return false;
  bool undecided = false;
  for (const Vec2& p : listed_world(a)) {
    if (box_distance_sq({p, p}, b.box) > reach_sq) continue;
    for (const Vec2& q : listed_world(b)) {
      const double apart_sq = distance_sq(p, q);
      if (apart_sq < link_sq) return true;
      undecided = undecided || apart_sq <= reach_sq;
    }
  }
  return undecided && returns_linked(a, b, returns);
}

// The plain comparison, of all returns of two runs whose listed ones are within reach.
bool ScanClusterer::returns_linked(const Run& a, const Run& b, const ScanReturns& returns) const {
  const double link_sq = link_distance_m_ * link_distance_m_;
  const double reach_m = link_distance_m_ + 2 * listing_distance_m_;
  const double reach_sq = reach_m * reach_m;
  const auto any_linked = [link_sq](std::span<const Vec2> some, std::span<const Vec2> others) {
    for (const Vec2& p : some)
      for (const Vec2& q : others)
        if (distance_sq(p, q) < link_sq) return true;
    return false;
  };
  for (std::uint32_t k = a.listed_begin; k < a.listed_end; ++k) {
    for (std::uint32_t l = b.listed_begin; l < b.listed_end; ++l) {
      if (distance_sq(listed_world_[k], listed_world_[l]) > reach_sq) continue;
      if (any_linked(represented(a, k, returns), represented(b, l, returns))) return true;
    }
  }
  return false;
}

std::span<const Vec2> ScanClusterer::represented(const Run& run, std::uint32_t listed,
                                                 const ScanReturns& returns) const {
  const std::uint32_t begin = returns.listed()[listed];
  const std::uint32_t end = listed + 1 < run.listed_end ? returns.listed()[listed + 1] : run.end;
  return returns.points_world().subspan(begin, end - begin);
}

// Leaves in each run the number of its cluster, counted in the order of the first runs.
void ScanClusterer::link_runs(const ScanReturns& returns) {
  const auto count = static_cast<std::uint32_t>(runs_.size());
  const auto root = [this](std::uint32_t run) {
    while (runs_[run].cluster != run) run = runs_[run].cluster;
    return run;
  };
  for (std::uint32_t j = 0; j < count; ++j) {
    runs_[j].cluster = j;
    if (count > 1) runs_[j].box = bounding_box(listed_world(runs_[j]));
    for (std::uint32_t i = 0; i < j; ++i) {
      const std::uint32_t a = root(i);
      const std::uint32_t b = root(j);
      if (a != b && runs_linked(runs_[i], runs_[j], returns))
        runs_[std::max(a, b)].cluster = std::min(a, b);
    }
  }
  std::uint32_t clusters = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    // A root is the first run of its cluster, so it has its number when the others ask for it.
    runs_[i].cluster = runs_[i].cluster == i ? clusters++ : runs_[runs_[i].cluster].cluster;
  }
  clusters_.resize(clusters);
  first_return_.resize(clusters);
}

void ScanClusterer::list_clusters(const ScanReturns& returns) {
  const std::span<const std::uint32_t> beams = returns.beams();
  const bool edges = !returns.full_circle();
  std::uint32_t clusters = 0;  // begun so far
  for (std::uint32_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    ScanCluster& cluster = clusters_[run.cluster];
    if (run.cluster == clusters) {
      ++clusters;
      first_return_[run.cluster] = run.begin;
      cluster.points_world = listed_world(run);
      cluster.cut_right = edges && beams[run.begin] == returns.first_measured();
    }
    cluster.cut_left = edges && beams[run.end - 1] == returns.last_measured();
  }
  if (edges && runs_.size() == clusters_.size()) return;
  std::size_t gathered = 0;
  for (std::uint32_t c = 0; c < clusters_.size(); ++c) gathered = gather(c, gathered, returns);
}

// Lists the runs of a cluster one after the other, from its first return on and around.
std::size_t ScanClusterer::gather(std::uint32_t cluster, std::size_t begin,
                                  const ScanReturns& returns) {
  if (returns.full_circle()) first_return_[cluster] = behind_widest_gap(cluster, returns);
  std::size_t end = begin;
  std::size_t before_first = begin;
  for (const Run& run : runs_) {
    if (run.cluster != cluster) continue;
    for (std::uint32_t i = run.listed_begin; i < run.listed_end; ++i) {
      if (returns.listed()[i] < first_return_[cluster]) ++before_first;
      gathered_world_[end++] = listed_world_[i];
    }
  }
  Vec2* const world = gathered_world_.data();
  std::rotate(world + begin, world + before_first, world + end);
  clusters_[cluster].points_world = {world + begin, end - begin};
  return end;
}

// The gap between the last and the first return counts as well, and is taken among equals.
std::uint32_t ScanClusterer::behind_widest_gap(std::uint32_t cluster,
                                               const ScanReturns& returns) const {
  const std::span<const std::uint32_t> beams = returns.beams();
  const std::uint32_t first = first_return_[cluster];
  std::uint32_t begin = first;
  std::uint32_t widest = 0;
  std::uint32_t previous = beams[first];
  for (const Run& run : runs_) {
    if (run.cluster != cluster) continue;
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const std::uint32_t gap = beams[i] - previous;
      previous = beams[i];
      if (gap <= widest) continue;
      widest = gap;
      begin = i;
    }
  }
  const std::size_t around = beams[first] + returns.beams_in_scan() - previous;
  return widest > around ? begin : first;
}

}  // namespace voronaut
