#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/planners/mapping/packed_point.h"

namespace voronaut {

// Stage 1 of the papers: what of a scan is a return, in the world frame and in the order of the
// beams, and which returns remain when neighbours are thinned. The storage is used again by every
// read().
class ScanReturns {
 public:
  // jump_distance_m >= thinning_distance_m.
  ScanReturns(double thinning_distance_m, double jump_distance_m)
      : thinning_distance_m_(thinning_distance_m), jump_distance_m_(jump_distance_m) {}

  // O(beams). The scan's ranges and beams must be equally many. Calls visit(p_world, index) for
  // each return as it is read; index() is its number.
  template <class Visit>
  void read(const Scan& scan, Visit visit);

  std::size_t size() const { return count_; }
  std::span<const Vec2> points_world() const { return {point_world_.data(), count_}; }
  std::span<const std::uint32_t> beams() const { return {beam_.data(), count_}; }
  // The returns that are not closer than the thinning distance to the one listed before them.
  std::span<const std::uint32_t> listed() const { return {listed_.data(), listed_count_}; }
  // Of the listed ones, which are not closer than the jump distance to the one listed before them;
  // the first of all is one.
  std::span<const std::uint32_t> jumps() const { return jumps_; }
  std::span<const Vec2> listed_world() const { return {listed_world_.data(), listed_count_}; }

  std::size_t beams_in_scan() const { return beams_in_scan_; }
  std::size_t invalid() const { return invalid_; }  // NaN, infinite, zero, negative, beyond range
  bool full_circle() const { return full_circle_; }
  // The rightmost and leftmost beams that measured anything, a miss included.
  std::uint32_t first_measured() const { return first_measured_; }
  std::uint32_t last_measured() const { return last_measured_; }

 private:
  static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
  void begin(const Scan& scan);
  void set_edges(const Scan& scan);

  double thinning_distance_m_;
  double jump_distance_m_;
  std::vector<Vec2> point_world_;  // the first count_ of each hold this scan
  std::vector<std::uint32_t> beam_;
  std::vector<std::uint32_t> listed_;
  std::vector<Vec2> listed_world_;
  std::vector<std::uint32_t> jumps_;
  std::size_t count_ = 0;
  std::size_t listed_count_ = 0;
  std::size_t beams_in_scan_ = 0;
  std::size_t invalid_ = 0;
  bool full_circle_ = false;
  std::uint32_t first_measured_ = 0;
  std::uint32_t last_measured_ = 0;
};

// Positive numbers are ordered as their bits are, and all others have larger ones: so one
// comparison tells a return. Most beams of most scans meet nothing and are passed by in fours.
template <class Visit>
void ScanReturns::read(const Scan& scan, Visit visit) {
  begin(scan);
  const std::size_t n = scan.size();
  const double* const range_m = scan.range_m.data();
  const Vec2* const direction = scan.beams->direction_sensor.data();
  const std::uint64_t miss = bits(scan.max_range_m);
  const PackedFrame sensor(scan.sensor_world);
  const double thinning_sq = thinning_distance_m_ * thinning_distance_m_;
  const double jump_sq = jump_distance_m_ * jump_distance_m_;
  const auto missed = [&](std::size_t i) { return bits(range_m[i]) == miss; };
  PackedPoint last_listed = packed(Vec2::Constant(std::numeric_limits<double>::infinity()));
  Vec2* point = point_world_.data();
  std::uint32_t* beam = beam_.data();
  std::uint32_t* listed = listed_.data();
  Vec2* listed_world = listed_world_.data();
  for (std::size_t i = 0; i < n;) {
    while (i + 4 <= n && missed(i) && missed(i + 1) && missed(i + 2) && missed(i + 3)) i += 4;
    while (i < n && missed(i)) ++i;
    for (; i < n && bits(range_m[i]) - 1 < miss - 1; ++i) {
      const PackedPoint p = sensor.at(direction[i], range_m[i]);
      const auto index = [&] { return static_cast<std::uint32_t>(point - point_world_.data()); };
      store(p, *point);
      *beam++ = static_cast<std::uint32_t>(i);
      const double apart_sq = distance_sq(p, last_listed);
      if (!(apart_sq < thinning_sq)) {
        if (!(apart_sq < jump_sq))
          jumps_.push_back(static_cast<std::uint32_t>(listed - listed_.data()));
        last_listed = p;
        *listed++ = index();
        store(p, *listed_world++);
      }
      visit(p, index);
      ++point;
    }
    for (; i < n && bits(range_m[i]) - 1 > miss - 1; ++i) ++invalid_;
  }
  count_ = static_cast<std::size_t>(point - point_world_.data());
  listed_count_ = static_cast<std::size_t>(listed - listed_.data());
  set_edges(scan);
}

}  // namespace voronaut
