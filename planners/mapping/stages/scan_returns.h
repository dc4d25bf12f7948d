#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "voronaut/environments/sensing/scan.h"
#include "voronaut/planners/mapping/points/packed_point.h"

namespace voronaut {

// Stage 1 of the papers: what of a scan is a return, in the order of the beams, which of them
// remain when neighbours are thinned, and where neighbours are not linked. Returns are named by
// their beams. The storage is used again by every read().
class ScanReturns {
 public:
  // Returns of which each is linked to the one before: those among the beams begin .. end - 1, the
  // first and the last of which are returns.
  struct Run {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t listed_begin = 0;  // indices into listed()
    std::uint32_t listed_end = 0;
  };

  // Returns closer than link_distance_m are linked. thinning_distance_m is not more than half of
  // it.
  ScanReturns(double thinning_distance_m, double link_distance_m)
      : thinning_distance_m_(thinning_distance_m), link_distance_m_(link_distance_m) {}

  // O(beams). The scan's ranges and beams must be equally many, and it must stay until the answers
  // are no longer asked. Calls visit(p_world, beam) for each return as it is read.
  template <class Visit>
  void read(const Scan& scan, Visit visit);

  std::size_t size() const { return count_; }
  std::uint32_t beams() const { return static_cast<std::uint32_t>(scan_->size()); }
  bool is_return(std::uint32_t beam) const { return scan_->is_return(beam); }
  Vec2 point_world(std::uint32_t beam) const { return scan_->point_world(beam); }
  // The returns that are not closer than the thinning distance to the one listed before them.
  std::span<const std::uint32_t> listed() const { return {listed_.data(), listed_count_}; }
  std::span<const Vec2> listed_world() const { return {listed_world_.data(), listed_count_}; }
  // In the order of the beams, as long as can be.
  std::span<const Run> runs() const { return {run_.data(), run_count_}; }

  std::size_t invalid() const { return invalid_; }  // NaN, infinite, zero, negative, beyond range
  bool full_circle() const { return scan_->beams->full_circle(); }
  // Is the rightmost (leftmost) beam that measured anything, a miss included, a return?
  bool first_at_edge() const { return first_at_edge_; }
  bool last_at_edge() const { return last_at_edge_; }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  static std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
  static std::size_t behind_misses(std::span<const double> range_m, double max_range_m,
                                   std::size_t i);
  void begin(const Scan& scan);
  void set_edges();
  void begin_run_unless_linked(std::size_t beam, std::size_t previous, std::size_t listed);
  void end_run(std::size_t last, std::size_t listed_end);

  double thinning_distance_m_;
  double link_distance_m_;
  const Scan* scan_ = nullptr;
  std::vector<std::uint32_t> listed_;  // the first *_count_ of each hold this scan
  std::vector<Vec2> listed_world_;
  std::vector<Run> run_;
  std::size_t count_ = 0;
  std::size_t listed_count_ = 0;
  std::size_t run_count_ = 0;
  std::size_t invalid_ = 0;
  bool first_at_edge_ = false;
  bool last_at_edge_ = false;
};

// Most beams of most scans meet nothing: they are passed by in eights.
inline std::size_t ScanReturns::behind_misses(std::span<const double> range_m, double max_range_m,
                                              std::size_t i) {
  while (i + 8 <= range_m.size() && all_eight_equal(range_m.data() + i, max_range_m)) i += 8;
  while (i < range_m.size() && range_m[i] == max_range_m) ++i;
  return i;
}

// Positive numbers are ordered as their bits are, and all others have larger ones: so one
// comparison tells a return. Only a listed return that is far from the one listed before can begin
// a run: the return before it is closer than the thinning distance to that one, and so are those
// between.
template <class Visit>
// One pass over the beams, the hottest loop of the map: parts of it cost a call or a second pass.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
void ScanReturns::read(const Scan& scan, Visit visit) {
  begin(scan);
  const std::size_t n = scan.size();
  const double* const range_m = scan.range_m.data();
  const Vec2* const direction = scan.beams->direction_sensor.data();
  const double max_range_m = scan.max_range_m;
  const std::uint64_t miss = bits(max_range_m);
  const PackedFrame sensor(scan.sensor_world);
  const double thinning_sq = thinning_distance_m_ * thinning_distance_m_;
  const double jump_m = link_distance_m_ - thinning_distance_m_;
  const double jump_sq = jump_m * jump_m;
  PackedPoint last_listed = packed(Vec2::Constant(std::numeric_limits<double>::infinity()));
  std::size_t last = kNone;  // return of the beams before
  std::uint32_t* listed = listed_.data();
  Vec2* listed_world = listed_world_.data();
  for (std::size_t i = 0; i < n;) {
    i = behind_misses({range_m, n}, max_range_m, i);
    const std::size_t first = i;
    for (; i < n && bits(range_m[i]) - 1 < miss - 1; ++i) {
      const PackedPoint p = sensor.at(direction[i], range_m[i]);
      const double apart_sq = distance_sq(p, last_listed);
      if (apart_sq >= thinning_sq) {
        if (apart_sq >= jump_sq) {
          begin_run_unless_linked(i, i > first ? i - 1 : last,
                                  static_cast<std::size_t>(listed - listed_.data()));
        }
        last_listed = p;
        *listed++ = static_cast<std::uint32_t>(i);
        store(p, *listed_world++);
      }
      visit(p, i);
    }
    if (i > first) last = i - 1;
    count_ += i - first;
    for (; i < n && bits(range_m[i]) - 1 > miss - 1; ++i) ++invalid_;
  }
  listed_count_ = static_cast<std::size_t>(listed - listed_.data());
  end_run(last, listed_count_);
  set_edges();
}

}  // namespace voronaut
