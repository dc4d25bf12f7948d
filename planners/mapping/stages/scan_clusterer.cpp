#include "voronaut/planners/mapping/stages/scan_clusterer.h"

#include <algorithm>
#include <limits>

#include "voronaut/planners/mapping/points/convex_polygon.h"

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
  runs_ = returns.runs();
  listed_world_ = returns.listed_world();
  if (returns.beams() > clusters_.size()) make_room(returns.beams());
  link_runs(returns);
  list_clusters(returns);
}

// A scan has no more listed returns, runs and clusters than beams.
void ScanClusterer::make_room(std::size_t beams) {
  gathered_world_.resize(beams);
  cluster_of_run_.resize(beams);
  box_of_run_.resize(beams);
  clusters_.resize(beams);
  first_return_.resize(beams);
}

// Listed returns decide mostly. Each stands for the returns up to the next listed one, all closer
// than the listing distance to it: where two are apart by little more than the link distance,
// these are compared.
bool ScanClusterer::runs_linked(std::size_t a, std::size_t b, const ScanReturns& returns) const {
  const double reach_m = link_distance_m_ + 2 * listing_distance_m_;
  const double reach_sq = reach_m * reach_m;
  if (box_distance_sq(box_of_run_[a], box_of_run_[b]) > reach_sq) return false;
  const double link_sq = link_distance_m_ * link_distance_m_;
  for (std::uint32_t k = runs_[a].listed_begin; k < runs_[a].listed_end; ++k) {
    const Vec2& p = listed_world_[k];
    if (box_distance_sq({p, p}, box_of_run_[b]) > reach_sq) continue;
    for (std::uint32_t l = runs_[b].listed_begin; l < runs_[b].listed_end; ++l) {
      const double apart_sq = distance_sq(p, listed_world_[l]);
      if (apart_sq < link_sq) return true;
      if (apart_sq <= reach_sq && represented_linked(runs_[a], k, runs_[b], l, returns))
        return true;
    }
  }
  return false;
}

bool ScanClusterer::represented_linked(const ScanReturns::Run& a, std::uint32_t listed_a,
                                       const ScanReturns::Run& b, std::uint32_t listed_b,
                                       const ScanReturns& returns) const {
  const double link_sq = link_distance_m_ * link_distance_m_;
  return any_represented(a, listed_a, returns, [&](const Vec2& p) {
    return any_represented(b, listed_b, returns,
                           [&](const Vec2& q) { return distance_sq(p, q) < link_sq; });
  });
}

template <class Visit>
bool ScanClusterer::any_represented(const ScanReturns::Run& run, std::uint32_t listed,
                                    const ScanReturns& returns, const Visit& visit) const {
  const std::uint32_t begin = returns.listed()[listed];
  const std::uint32_t end = listed + 1 < run.listed_end ? returns.listed()[listed + 1] : run.end;
  for (std::uint32_t beam = begin; beam < end; ++beam) {
    if (returns.is_return(beam) && visit(returns.point_world(beam))) return true;
  }
  return false;
}

// Leaves in each run the number of its cluster, counted in the order of the first runs.
void ScanClusterer::link_runs(const ScanReturns& returns) {
  const auto count = static_cast<std::uint32_t>(runs_.size());
  const std::span<std::uint32_t> joined_to = cluster_of_run_;
  const auto root = [joined_to](std::uint32_t run) {
    while (joined_to[run] != run) run = joined_to[run];
    return run;
  };
  for (std::uint32_t j = 0; j < count; ++j) {
    joined_to[j] = j;
    if (count > 1) box_of_run_[j] = bounding_box(listed_world(runs_[j]));
    for (std::uint32_t i = 0; i < j; ++i) {
      const std::uint32_t a = root(i);
      const std::uint32_t b = root(j);
      if (a != b && runs_linked(i, j, returns)) joined_to[std::max(a, b)] = std::min(a, b);
    }
  }
  std::uint32_t clusters = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    // A root is the first run of its cluster, so it has its number when the others ask for it.
    cluster_of_run_[i] = joined_to[i] == i ? clusters++ : cluster_of_run_[joined_to[i]];
  }
  cluster_count_ = clusters;
}

void ScanClusterer::list_clusters(const ScanReturns& returns) {
  const bool edges = !returns.full_circle();
  std::uint32_t clusters = 0;  // begun so far
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const std::uint32_t c = cluster_of_run_[i];
    if (c == clusters) {
      ++clusters;
      first_return_[c] = runs_[i].begin;
      clusters_[c].points_world = listed_world(runs_[i]);
      clusters_[c].cut_right = edges && i == 0 && returns.first_at_edge();
    }
    clusters_[c].cut_left = edges && i + 1 == runs_.size() && returns.last_at_edge();
  }
  if (edges && runs_.size() == cluster_count_) return;
  std::size_t gathered = 0;
  for (std::uint32_t c = 0; c < cluster_count_; ++c) gathered = gather(c, gathered, returns);
}

// Lists the runs of a cluster one after the other, from its first return on and around.
std::size_t ScanClusterer::gather(std::uint32_t cluster, std::size_t begin,
                                  const ScanReturns& returns) {
  if (returns.full_circle()) first_return_[cluster] = behind_widest_gap(cluster, returns);
  std::size_t end = begin;
  std::size_t before_first = begin;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    if (cluster_of_run_[r] != cluster) continue;
    for (std::uint32_t i = runs_[r].listed_begin; i < runs_[r].listed_end; ++i) {
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
  const std::uint32_t first = first_return_[cluster];
  std::uint32_t begin = first;
  std::uint32_t widest = 0;
  std::uint32_t previous = first;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    if (cluster_of_run_[r] != cluster) continue;
    for (std::uint32_t i = runs_[r].begin; i < runs_[r].end; ++i) {
      if (!returns.is_return(i)) continue;
      const std::uint32_t gap = i - previous;
      previous = i;
      if (gap <= widest) continue;
      widest = gap;
      begin = i;
    }
  }
  const std::uint32_t around = first + returns.beams() - previous;
  return widest > around ? begin : first;
}

}  // namespace voronaut
