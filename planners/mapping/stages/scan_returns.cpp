#include "voronaut/planners/mapping/stages/scan_returns.h"

#include <algorithm>

#include "voronaut/planners/mapping/points/require.h"

namespace voronaut {

void ScanReturns::begin(const Scan& scan) {
  const std::size_t n = scan.size();
  require(scan.beams != nullptr && scan.beams->direction_sensor.size() == n,
          "Scan: as many ranges as beams");
  require(scan.max_range_m > 0, "Scan: max_range_m is not positive");
  if (n > listed_.size()) {
    listed_.resize(n);
    listed_world_.resize(n);
    run_.resize(n);
  }
  scan_ = &scan;
  count_ = 0;
  run_count_ = 0;
  invalid_ = 0;
}

void ScanReturns::begin_run_unless_linked(std::size_t beam, std::size_t previous,
                                          std::size_t listed) {
  if (previous != kNone) {
    const Vec2 apart = scan_->point_world(beam) - scan_->point_world(previous);
    if (apart.squaredNorm() < link_distance_m_ * link_distance_m_) return;
    end_run(previous, listed);
  }
  Run& run = run_[run_count_++];
  run.begin = static_cast<std::uint32_t>(beam);
  run.listed_begin = static_cast<std::uint32_t>(listed);
}

void ScanReturns::end_run(std::size_t last, std::size_t listed_end) {
  if (run_count_ == 0) return;
  run_[run_count_ - 1].end = static_cast<std::uint32_t>(last + 1);
  run_[run_count_ - 1].listed_end = static_cast<std::uint32_t>(listed_end);
}

void ScanReturns::set_edges() {
  const std::span<const double> range_m = scan_->range_m;
  const double max_range_m = scan_->max_range_m;
  const auto measured = [=](double range) { return range > 0 && range <= max_range_m; };
  const auto first = std::find_if(range_m.begin(), range_m.end(), measured);
  const auto last = std::find_if(range_m.rbegin(), range_m.rend(), measured);
  first_at_edge_ = first != range_m.end() && *first < max_range_m;
  last_at_edge_ = last != range_m.rend() && *last < max_range_m;
}

}  // namespace voronaut
