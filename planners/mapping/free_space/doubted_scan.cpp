#include "voronaut/planners/mapping/free_space/doubted_scan.h"

#include <algorithm>
#include <numbers>

namespace voronaut {

namespace {

// Above asin(x), by no more than 5 % up to a half: the C library's differs between processors.
double asin_at_most(double x) {
  constexpr double kUpToHalf = 1.0472;  // asin(0.5) / 0.5
  return (x <= 0.5 ? kUpToHalf : 0.5 * std::numbers::pi) * x;
}

bool measured(const Scan& scan, std::size_t beam) {
  return scan.range_m[beam] > 0 && scan.range_m[beam] <= scan.max_range_m;
}

}  // namespace

DoubtedScan::DoubtedScan(const SensingErrors& errors, double nearest_m)
    : errors_(errors), nearest_m_(nearest_m) {}

const Scan& DoubtedScan::of(const Scan& scan) {
  doubted_ = scan;
  const auto beams = static_cast<std::ptrdiff_t>(scan.size());
  for (std::ptrdiff_t beam = 0; beam < beams; ++beam) {
    const auto i = static_cast<std::size_t>(beam);
    shorten_about(beam, measured(scan, i) ? scan.range_m[i] - errors_.range_m : nearest_m_, scan);
    if (!measured(scan, i)) doubted_.range_m[i] = 0;
  }
  if (!scan.beams->full_circle()) {
    shorten_about(-1, nearest_m_, scan);
    shorten_about(beams, nearest_m_, scan);
  }
  return doubted_;
}

// Within which a beam of this range shortens others.
double DoubtedScan::angle_rad(double range_m) const {
  const double from_m = std::max(range_m - errors_.position_m, nearest_m_);
  return errors_.heading_rad + asin_at_most(std::min(1.0, errors_.position_m / from_m));
}

void DoubtedScan::shorten_about(std::ptrdiff_t beam, double range_m, const Scan& scan) {
  const auto beams = static_cast<std::ptrdiff_t>(scan.size());
  const double step_rad = scan.beams->bearing_step_rad;
  const double reach = step_rad > 0 ? angle_rad(range_m) / step_rad : 0;
  const auto aside = std::min(static_cast<std::ptrdiff_t>(reach) + 1, beams - 1);
  const double left_m = std::max(0.0, range_m - errors_.position_m);
  const bool circle = scan.beams->full_circle();
  for (std::ptrdiff_t at = beam - aside; at <= beam + aside; ++at) {
    if (!circle && (at < 0 || at >= beams)) continue;
    double& other_m = doubted_.range_m[static_cast<std::size_t>((at + beams) % beams)];
    other_m = std::min(other_m, left_m);
  }
}

}  // namespace voronaut
