#include "voronaut/planners/mapping/scan_returns.h"

#include "voronaut/planners/mapping/require.h"

namespace voronaut {

void ScanReturns::begin(const Scan& scan) {
  const std::size_t n = scan.size();
  require(scan.beams != nullptr && scan.beams->direction_sensor.size() == n,
          "Scan: as many ranges as beams");
  require(scan.max_range_m > 0, "Scan: max_range_m is not positive");
  if (n > point_world_.size()) {
    point_world_.resize(n);
    beam_.resize(n);
    listed_.resize(n);
    listed_world_.resize(n);
  }
  beams_in_scan_ = n;
  full_circle_ = scan.beams->full_circle();
  invalid_ = 0;
  jumps_.clear();
}

void ScanReturns::set_edges(const Scan& scan) {
  const std::span<const double> range_m = scan.range_m;
  const double max_range_m = scan.max_range_m;
  const std::size_t n = range_m.size();
  const auto measured = [&](std::size_t k) { return range_m[k] > 0 && range_m[k] <= max_range_m; };
  std::size_t first = 0;
  while (first < n && !measured(first)) ++first;
  std::size_t last = n;
  while (last > first && !measured(last - 1)) --last;
  first_measured_ = static_cast<std::uint32_t>(first);
  last_measured_ = static_cast<std::uint32_t>(last == 0 ? 0 : last - 1);
}

}  // namespace voronaut
