#include "voronaut/planners/mapping/scan_returns.h"

#include <bit>
#include <limits>

#include "voronaut/planners/mapping/convex_polygon.h"
#include "voronaut/planners/mapping/require.h"

namespace voronaut {
namespace {

constexpr std::size_t kBlock = 4;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

// Most beams of most scans meet nothing: a whole block of misses is passed by at once.
bool all_miss(const double* range_m, std::uint64_t max_range_bits) {
  return ((bits(range_m[0]) ^ max_range_bits) | (bits(range_m[1]) ^ max_range_bits) |
          (bits(range_m[2]) ^ max_range_bits) | (bits(range_m[3]) ^ max_range_bits)) == 0;
}

}  // namespace

void ScanReturns::read(const Scan& scan) {
  const std::size_t n = scan.size();
  require(scan.beams != nullptr && scan.beams->direction_sensor.size() == n,
          "Scan: as many ranges as beams");
  if (n > point_world_.size()) {
    point_world_.resize(n);
    beam_.resize(n);
    listed_.resize(n);
  }
  beams_in_scan_ = n;
  full_circle_ = scan.beams->full_circle();
  const double* const range_m = scan.range_m.data();
  const Vec2* const direction = scan.beams->direction_sensor.data();
  const double max_range_m = scan.max_range_m;
  const double thinning_sq = thinning_distance_m_ * thinning_distance_m_;
  const Vec2 origin = scan.sensor_world.p_world;
  const Vec2 heading = scan.sensor_world.heading;
  Vec2* const point = point_world_.data();
  std::uint32_t* const beam = beam_.data();
  std::uint32_t* const listed = listed_.data();
  Vec2 last_listed = Vec2::Constant(std::numeric_limits<double>::infinity());
  std::size_t count = 0;
  std::size_t listed_count = 0;
  invalid_ = 0;
  for (std::size_t i = 0; i < n;) {
    while (i + kBlock <= n && all_miss(range_m + i, bits(max_range_m))) i += kBlock;
    while (i < n && range_m[i] == max_range_m) ++i;
    for (; i < n && range_m[i] > 0 && range_m[i] < max_range_m; ++i) {
      const double dx = direction[i].x();
      const double dy = direction[i].y();
      const double x = origin.x() + range_m[i] * (heading.x() * dx - heading.y() * dy);
      const double y = origin.y() + range_m[i] * (heading.y() * dx + heading.x() * dy);
      point[count] = {x, y};
      beam[count] = static_cast<std::uint32_t>(i);
      if (!(distance_sq({x, y}, last_listed) < thinning_sq)) {
        last_listed = {x, y};
        listed[listed_count++] = static_cast<std::uint32_t>(count);
      }
      ++count;
    }
    for (; i < n && !(range_m[i] > 0 && range_m[i] <= max_range_m); ++i) ++invalid_;
  }
  count_ = count;
  listed_count_ = listed_count;
  set_edges(scan);
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
