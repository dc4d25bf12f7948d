#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "voronaut/environments/scan.h"

namespace voronaut {

// Stage 1 of the papers: what of a scan is a return, in the world frame and in the order of the
// beams. The storage is used again by every read().
class ScanReturns {
 public:
  // O(beams). The scan's ranges and beams must be equally many.
  void read(const Scan& scan);

  std::size_t size() const { return count_; }
  std::span<const Vec2> points_world() const { return {point_world_.data(), count_}; }
  std::span<const std::uint32_t> beams() const { return {beam_.data(), count_}; }

  std::size_t beams_in_scan() const { return beams_in_scan_; }
  std::size_t invalid() const { return invalid_; }  // NaN, infinite, zero, negative, beyond range
  bool full_circle() const { return full_circle_; }
  // The rightmost and leftmost beams that measured anything, a miss included.
  std::uint32_t first_measured() const { return first_measured_; }
  std::uint32_t last_measured() const { return last_measured_; }

 private:
  std::vector<Vec2> point_world_;  // the first count_ of each hold this scan
  std::vector<std::uint32_t> beam_;
  std::size_t count_ = 0;
  std::size_t beams_in_scan_ = 0;
  std::size_t invalid_ = 0;
  bool full_circle_ = false;
  std::uint32_t first_measured_ = 0;
  std::uint32_t last_measured_ = 0;
};

}  // namespace voronaut
