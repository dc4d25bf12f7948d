#include "voronaut/planners/mapping/scan_returns.h"

#include <bit>

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
  }
  beams_in_scan_ = n;
  full_circle_ = scan.beams->full_circle();
  const double* const range_m = scan.range_m.data();
  const Vec2* const direction = scan.beams->direction_sensor.data();
  const double max_range_m = scan.max_range_m;
  const Vec2 origin = scan.sensor_world.p_world;
  const Vec2 heading = scan.sensor_world.heading;
  Vec2* point = point_world_.data();
  std::uint32_t* beam = beam_.data();
  std::size_t invalid = 0;
  const auto take = [&](std::size_t i) {
    const double range = range_m[i];
    if (range < max_range_m && range > 0) {
      const double x = direction[i].x();
      const double y = direction[i].y();
      *point++ = {origin.x() + range * (heading.x() * x - heading.y() * y),
                  origin.y() + range * (heading.y() * x + heading.x() * y)};
      *beam++ = static_cast<std::uint32_t>(i);
    } else if (range != max_range_m) {
      ++invalid;
    }
  };
  std::size_t i = 0;
  for (; i + kBlock <= n; i += kBlock) {
    if (all_miss(range_m + i, bits(max_range_m))) continue;
    for (std::size_t k = 0; k < kBlock; ++k) take(i + k);
  }
  for (; i < n; ++i) take(i);
  count_ = static_cast<std::size_t>(beam - beam_.data());
  invalid_ = invalid;

  const auto measured = [&](std::size_t k) { return range_m[k] > 0 && range_m[k] <= max_range_m; };
  std::size_t first = 0;
  while (first < n && !measured(first)) ++first;
  std::size_t last = n;
  while (last > first && !measured(last - 1)) --last;
  first_measured_ = static_cast<std::uint32_t>(first);
  last_measured_ = static_cast<std::uint32_t>(last == 0 ? 0 : last - 1);
}

}  // namespace voronaut
