#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/planners/mapping/points/scan_cluster.h"
#include "voronaut/planners/mapping/stages/scan_returns.h"

namespace voronaut {

// Single linkage of the returns of one scan. Returns in the order of the beams fall into runs, in
// which each is linked to the one before; runs of which any two returns are linked are one cluster,
// so that a post in front of a wall does not cut the wall in two. O(returns), and per pair of runs
// whose boxes are near each other the pairs of their thinned returns.
class ScanClusterer {
 public:
  ScanClusterer(double link_distance_m, double thinning_distance_m);

  // How returns must be thinned for it: at the thinning distance, and not at more than half of the
  // link distance, so that a return left out is linked to those around it.
  double listing_distance_m() const { return listing_distance_m_; }

  // `returns` are thinned at listing_distance_m() and linked at the same distance, and stay until
  // the answers are no longer asked.
  void cluster(const ScanReturns& returns);

  // Of a run of the returns: index into clusters().
  std::uint32_t cluster_of_run(std::size_t run) const { return cluster_of_run_[run]; }
  // In the order of their first beams. Valid, like the rest, until the next scan.
  std::span<ScanCluster> clusters() { return {clusters_.data(), cluster_count_}; }
  std::span<const ScanCluster> clusters() const { return {clusters_.data(), cluster_count_}; }
  // The return with which a cluster begins: its rightmost, in a full circle the one behind its
  // widest gap in bearing.
  std::uint32_t first_return(std::size_t cluster) const { return first_return_[cluster]; }

 private:
  std::span<const Vec2> listed_world(const ScanReturns::Run& run) const {
    return listed_world_.subspan(run.listed_begin, run.listed_end - run.listed_begin);
  }
  void make_room(std::size_t beams);
  void link_runs(const ScanReturns& returns);
  bool runs_linked(std::size_t a, std::size_t b, const ScanReturns& returns) const;
  bool represented_linked(const ScanReturns::Run& a, std::uint32_t listed_a,
                          const ScanReturns::Run& b, std::uint32_t listed_b,
                          const ScanReturns& returns) const;
  // Visits the returns that a listed one stands for until one visit is true; was one?
  template <class Visit>
  bool any_represented(const ScanReturns::Run& run, std::uint32_t listed,
                       const ScanReturns& returns, const Visit& visit) const;
  void list_clusters(const ScanReturns& returns);
  std::size_t gather(std::uint32_t cluster, std::size_t begin, const ScanReturns& returns);
  std::uint32_t behind_widest_gap(std::uint32_t cluster, const ScanReturns& returns) const;

  double link_distance_m_;
  double listing_distance_m_;
  std::span<const ScanReturns::Run> runs_;
  std::span<const Vec2> listed_world_;
  std::vector<std::uint32_t> cluster_of_run_;
  std::vector<Bounds> box_of_run_;     // of the listed returns; set if there are several runs
  std::vector<Vec2> gathered_world_;   // of clusters that are not one run
  std::vector<ScanCluster> clusters_;  // the first cluster_count_ are in use
  std::vector<std::uint32_t> first_return_;
  std::size_t cluster_count_ = 0;
};

}  // namespace voronaut
