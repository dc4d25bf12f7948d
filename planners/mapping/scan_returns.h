#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"

namespace voronaut {

// Stage 1 of the papers: what of a scan is a return, in the world frame and in the order of the
// beams, and which returns remain when neighbours are thinned. The storage is used again by every
// read().
class ScanReturns {
 public:
  explicit ScanReturns(double thinning_distance_m) : thinning_distance_m_(thinning_distance_m) {}

  // O(beams). The scan's ranges and beams must be equally many.
  void read(const Scan& scan);

  std::size_t size() const { return count_; }
  std::span<const Vec2> points_world() const { return {point_world_.data(), count_}; }
  std::span<const std::uint32_t> beams() const { return {beam_.data(), count_}; }
  // The returns that are not closer than the thinning distance to the one listed before them.
  std::span<const std::uint32_t> listed() const { return {listed_.data(), listed_count_}; }

  std::size_t beams_in_scan() const { return beams_in_scan_; }
  std::size_t invalid() const { return invalid_; }  // NaN, infinite, zero, negative, beyond range
  bool full_circle() const { return full_circle_; }
  // The rightmost and leftmost beams that measured anything, a miss included.
  std::uint32_t first_measured() const { return first_measured_; }
  std::uint32_t last_measured() const { return last_measured_; }

 private:
  void set_edges(const Scan& scan);

  double thinning_distance_m_;
  std::vector<Vec2> point_world_;  // the first count_ of each hold this scan
  std::vector<std::uint32_t> beam_;
  std::vector<std::uint32_t> listed_;
  std::size_t count_ = 0;
  std::size_t listed_count_ = 0;
  std::size_t beams_in_scan_ = 0;
  std::size_t invalid_ = 0;
  bool full_circle_ = false;
  std::uint32_t first_measured_ = 0;
  std::uint32_t last_measured_ = 0;
};

}  // namespace voronaut
